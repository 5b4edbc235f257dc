// The passes of a frame, in the order in which they run. README.md says who rasterises what.

#include "render/frame_passes.h"

#include <array>

#include "render/picture_drawing.h"
#include "render/tile_drawing.h"

namespace fumon {

namespace {

constexpr Targets nothing{};
constexpr Targets of_picture{Target::sky_radiances, Target::bed_maps,  Target::bed_colours,
                             Target::ground_mesh,   Target::instances, Target::sun_share};

/// Whether each pass reads only what a pass before it, or one of the picture's, writes.
template <typename Drawing>
constexpr bool reads_what_is_written(std::span<const Pass<Drawing>> passes, Targets written) {
    for (const Pass<Drawing>& pass : passes) {
        if (!written.has(pass.reads)) return false;
        written = written | pass.writes;
    }
    return true;
}

}  // namespace

std::span<const Pass<PictureDrawing>> picture_passes() {
    using enum Target;
    using P = PictureDrawing;
    // clang-format off
    static constexpr std::array<Pass<P>, 13> passes{{
        // name                          needed             reads                     writes            done by
        {"upload bed maps",              &P::fresh,         nothing,                  {bed_maps},       &P::upload_bed_maps},
        {"upload endless ground",        &P::fresh_world,   nothing,                  {bed_maps},       &P::upload_world_maps},
        {"bind sky's radiances",         &P::always,        nothing,                  {sky_radiances},  &P::bind_sky},
        {"shade bed",                    &P::fresh,         {bed_maps, sky_radiances},{bed_colours},    &P::shade_bed},
        {"take endless ground's mesh",   &P::of_world,      nothing,                  {ground_mesh},    &P::take_world_mesh},
        {"mesh block",                   &P::of_block,      {bed_maps},               {ground_mesh},    &P::mesh_block},
        {"place plants",                 &P::fresh_plants,  nothing,                  {instances},      &P::place_plants},
        {"place persons",                &P::fresh_persons, nothing,                  {instances},      &P::place_persons},
        {"place prints",                 &P::fresh_tracks,  {bed_maps},               {instances},      &P::place_prints},
        {"look through clouds at sun",   &P::always,        nothing,                  {sun_share},      &P::look_at_sun},
        {"paint air",                    &P::with_air,      nothing,                  {instances},      &P::paint_air},
        {"choose plants",                &P::with_plants,   {ground_mesh, instances}, {instances},      &P::choose_plants},
        {"choose streamers",             &P::with_streamers,{ground_mesh},            {instances},      &P::choose_streamers},
    }};
    // clang-format on
    static_assert(reads_what_is_written<P>(passes, nothing));
    return passes;
}

std::span<const Pass<TileDrawing>> block_passes() {
    using enum Target;
    using T = TileDrawing;
    // clang-format off
    static constexpr std::array<Pass<T>, 7> passes{{
        // name                          needed             reads                                   writes                     done by
        {"draw dry surface",             &T::dry,           {ground_mesh, bed_colours},             {coverage, picture},       &T::draw_dry_block},
        {"rasterise water",              &T::wet,           {ground_mesh},                          {coverage},                &T::rasterise_water},
        {"shade water",                  &T::wet,           {coverage, bed_maps},                   {water_colours},           &T::shade_water},
        {"resolve water",                &T::wet,           {coverage, water_colours},              {coverage, picture},       &T::resolve_water},
        {"background beside block",      &T::closed,        {coverage, sun_share},                  {background},              &T::draw_background_beside_block},
        {"shade sides",                  &T::always,        {coverage, ground_mesh},                {side_colours},            &T::shade_sides},
        {"composite",                    &T::always,        {coverage, side_colours, background},   {picture},                 &T::composite},
    }};
    // clang-format on
    static_assert(reads_what_is_written<T>(passes, of_picture));
    return passes;
}

std::span<const Pass<TileDrawing>> sample_passes() {
    using enum Target;
    using T = TileDrawing;
    // clang-format off
    static constexpr std::array<Pass<T>, 22> passes{{
        // name                          needed             reads                                   writes                     done by
        {"background",                   &T::behind_first,  {sun_share},                            {background},              &T::draw_background},
        {"rasterise ground, vectors",    &T::in_buffer,     {ground_mesh},                          {visibility_buffer},       &T::rasterise_world_buffer},
        {"clear visibility",             &T::in_target,     nothing,                                {visibility},              &T::clear_visibility},
        {"copy visibility",              &T::copied,        {visibility_buffer},                    {visibility},              &T::copy_visibility},
        {"rasterise ground, OpenGL",     &T::world_target,  {ground_mesh},                          {visibility},              &T::rasterise_world},
        {"rasterise block, OpenGL",      &T::of_block,      {ground_mesh},                          {visibility},              &T::rasterise_block},
        {"streamers",                    &T::streamed,      {visibility, instances},                {streamed_light},          &T::draw_streamers},
        {"shade water",                  &T::water_pixels,  {visibility, bed_maps},                 {water_colours},           &T::shade_water_samples},
        {"shade whole pixels",           &T::whole_pixels,  {visibility_buffer, bed_colours, streamed_light}, {pixel_colours}, &T::shade_world_pixels},
        {"shade edges",                  &T::packed,        {visibility_buffer, visibility, pixel_colours, bed_colours, streamed_light},
                                                                                                    {edge_colours},            &T::shade_world_edges},
        {"clear samples",                &T::unpacked,      nothing,                                {sample_colours},          &T::clear_samples},
        {"background behind samples",    &T::behind_lens,   {visibility, streamed_light, sun_share},{sample_colours},          &T::draw_background_behind_samples},
        {"background behind air",        &T::behind_air,    {background},                           {sample_colours},          &T::draw_background_behind_air},
        {"upsample whole pixels",        &T::upsampled,     {pixel_colours},                        {sample_colours},          &T::upsample_world_pixels},
        {"shade ground",                 &T::world_samples, {visibility_buffer, visibility, bed_colours, streamed_light},
                                                                                                    {sample_colours},          &T::shade_world},
        {"shade block",                  &T::of_block,      {visibility, bed_colours, water_colours},{sample_colours},         &T::shade_block},
        {"prints",                       &T::with_tracks,   {visibility, bed_maps, instances},      {sample_colours},          &T::draw_prints},
        {"plants",                       &T::with_plants,   {bed_maps, instances, streamed_light},  {sample_colours},          &T::draw_plants},
        {"persons",                      &T::with_persons,  {bed_maps, instances, streamed_light},  {sample_colours},          &T::draw_persons},
        {"air",                          &T::with_air,      {instances},                            {sample_colours},          &T::draw_air},
        {"background where ground ends", &T::behind_last,   {visibility_buffer, streamed_light, sun_share}, {background},      &T::draw_uncovered_background},
        {"resolve",                      &T::always,        {sample_colours, pixel_colours, edge_colours, background}, {picture}, &T::resolve},
    }};
    // clang-format on
    static_assert(reads_what_is_written<T>(passes, of_picture));
    return passes;
}

}  // namespace fumon
