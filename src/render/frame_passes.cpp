// The passes of a frame, in the order in which they run. README.md says who rasterises what.

#include "render/frame_passes.h"

#include <array>

#include "render/picture_drawing.h"
#include "render/tile_drawing.h"

namespace fumon {

namespace {

constexpr Targets nothing{};
constexpr Targets of_picture{Target::light, Target::bed_maps, Target::bed_colours,
                             Target::ground_mesh, Target::instances};

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
        // name                        needed              writes         done by                reads
        {"upload bed maps",            &P::fresh,          {bed_maps},    &P::upload_bed_maps,   nothing},
        {"upload endless ground",      &P::fresh_world,    {bed_maps},    &P::upload_world_maps, nothing},
        {"bind sky's radiances",       &P::always,         {light},       &P::bind_sky,          nothing},
        {"shade bed",                  &P::fresh,          {bed_colours}, &P::shade_bed,         {bed_maps, light}},
        {"take endless ground's mesh", &P::of_world,       {ground_mesh}, &P::take_world_mesh,   nothing},
        {"mesh block",                 &P::of_block,       {ground_mesh}, &P::mesh_block,        {bed_maps}},
        {"place plants",               &P::fresh_plants,   {instances},   &P::place_plants,      nothing},
        {"place persons",              &P::fresh_persons,  {instances},   &P::place_persons,     nothing},
        {"place prints",               &P::fresh_tracks,   {instances},   &P::place_prints,      {bed_maps}},
        {"look through clouds at sun", &P::always,         {light},       &P::look_at_sun,       nothing},
        {"paint air",                  &P::with_air,       {instances},   &P::paint_air,         nothing},
        {"choose plants",              &P::with_plants,    {instances},   &P::choose_plants,     {ground_mesh, instances}},
        {"choose streamers",           &P::with_streamers, {instances},   &P::choose_streamers,  {ground_mesh}},
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
        // name                     needed      writes               done by                           reads
        {"draw dry surface",        &T::dry,    {coverage, picture}, &T::draw_dry_block,               {ground_mesh, bed_colours}},
        {"rasterise water",         &T::wet,    {coverage},          &T::rasterise_water,              {ground_mesh}},
        {"shade water",             &T::wet,    {water_colours},     &T::shade_water,                  {coverage, bed_maps, light}},
        {"resolve water",           &T::wet,    {coverage, picture}, &T::resolve_water,                {coverage, water_colours}},
        {"background beside block", &T::closed, {background},        &T::draw_background_beside_block, {coverage, light}},
        {"shade sides",             &T::always, {side_colours},      &T::shade_sides,                  {coverage, ground_mesh, light}},
        {"composite",               &T::always, {picture},           &T::composite,                    {coverage, side_colours, background}},
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
        // name                          needed             writes               done by                             reads
        {"background",                   &T::behind_first,  {background},        &T::draw_background,                {light}},
        {"rasterise ground, vectors",    &T::has_visibility_buffer,     {visibility_buffer}, &T::rasterise_world_buffer,         {ground_mesh}},
        {"clear visibility",             &T::in_target,     {visibility},        &T::clear_visibility,               nothing},
        {"copy visibility",              &T::copied,        {visibility},        &T::copy_visibility,                {visibility_buffer}},
        {"rasterise ground, OpenGL",     &T::world_target,  {visibility},        &T::rasterise_world,                {ground_mesh}},
        {"rasterise block, OpenGL",      &T::of_block,      {visibility},        &T::rasterise_block,                {ground_mesh}},
        {"streamers",                    &T::streamed,      {streamed_light},    &T::draw_streamers,                 {visibility, instances, light}},
        {"shade water",                  &T::water_pixels,  {water_colours},     &T::shade_water_samples,            {visibility, bed_maps, light}},
        {"shade whole pixels",           &T::single_surface_pixels,  {pixel_colours},     &T::shade_world_pixels,             {visibility_buffer, bed_maps, bed_colours, streamed_light, light}},
        {"shade edges",                  &T::packed,        {edge_colours},      &T::shade_world_edges,              {visibility_buffer, visibility, pixel_colours, bed_maps, bed_colours, streamed_light, light}},
        {"clear samples",                &T::unpacked,      {sample_colours},    &T::clear_samples,                  nothing},
        {"background behind samples",    &T::behind_lens,   {sample_colours},    &T::draw_background_behind_samples, {visibility, streamed_light, light}},
        {"background behind air",        &T::behind_air,    {sample_colours},    &T::draw_background_behind_air,     {background}},
        {"upsample whole pixels",        &T::upsampled,     {sample_colours},    &T::upsample_world_pixels,          {pixel_colours}},
        {"shade ground",                 &T::world_samples, {sample_colours},    &T::shade_world,                    {visibility_buffer, visibility, bed_maps, bed_colours, streamed_light, light}},
        {"shade block",                  &T::of_block,      {sample_colours},    &T::shade_block,                    {visibility, ground_mesh, bed_colours, water_colours, light}},
        {"prints",                       &T::with_tracks,   {sample_colours},    &T::draw_prints,                    {visibility_buffer, visibility, bed_maps, bed_colours, instances, streamed_light, light}},
        {"plants",                       &T::with_plants,   {sample_colours},    &T::draw_plants,                    {bed_maps, instances, streamed_light, light}},
        {"persons",                      &T::with_persons,  {sample_colours},    &T::draw_persons,                   {bed_maps, instances, streamed_light, light}},
        {"air",                          &T::with_air,      {sample_colours},    &T::draw_air,                       {instances}},
        {"background where ground ends", &T::behind_last,   {background},        &T::draw_uncovered_background,      {visibility_buffer, streamed_light, light}},
        {"resolve",                      &T::always,        {picture},           &T::resolve,                        {sample_colours, pixel_colours, edge_colours, background}},
    }};
    // clang-format on
    static_assert(reads_what_is_written<T>(passes, of_picture));
    return passes;
}

}  // namespace fumon
