#include "render/renderer_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gl/functions.h"
#include "render/frame/clouds.h"
#include "render/frame/view_uniforms.h"
#include "render/light/floor_map.h"
#include "render/light/lighting.h"
#include "render/light/view_light.h"
#include "render/view/chosen_ground.h"
#include "render/view/display_bed.h"
#include "render/view/framing.h"
#include "render/view/repeated_bed.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

/// Cells along the bed's longer side from which on it is drawn as it is. On endless ground one may
/// stand.
int smooth_enough(Ground ground, bool draft) {
    if (draft) return 200;
    return ground == Ground::endless ? 1000 : 400;
}

/// Cells of the maps of a bed in its plain, at most.
constexpr double most_cells_in_plain = 8.6e6;

int chosen_refinement(const View& view, const Snapshot& first, const Snapshot& ground, bool draft) {
    const int wanted =
        refinement_of(first.bed.nx(), first.bed.ny(),
                      static_cast<int>(std::max(view.image.width, view.image.height)),
                      smooth_enough(view.look.ground, draft));
    if (&first == &ground) return wanted;
    const double most = std::sqrt(most_cells_in_plain / static_cast<double>(ground.bed.size()));
    return std::clamp(static_cast<int>(most), 1, wanted);
}

std::optional<PlainAround> plain_of(const View& view, const Snapshot& first, WorkerPool& pool) {
    if (view.look.ground != Ground::endless || !ends_somewhere(first)) return std::nullopt;
    return PlainAround(first, pool);
}

TilePlan plan_of(const View& view, const RenderLimits& limits) {
    GLint largest = 0;
    gl::functions().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return plan_tiles(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                      view.camera.has_lens() ? 1 : static_cast<int>(view.image.supersampling),
                      std::min(limits.tile_samples, static_cast<int>(largest)));
}

const gl::TextureLayout sky_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};

/// What lies dark on the plain around the block; nothing where no plain is drawn.
FloorMap floor_of(const View& view, const Snapshot& first, const Block& block, int refinement,
                  WorkerPool& pool) {
    const bool seen = view.look.mode == ViewMode::scenic && view.look.ground != Ground::endless &&
                      view.look.background != Background::transparent;
    if (!seen) return open_floor();
    return floor_map(display_bed(first, block, refinement), block, sun_direction(view.sun), pool);
}

/// The samples of the first tile, and those beside them.
SampleRectangle samples_of(const TilePlan& plan) {
    const glm::ivec2 pixels(plan.tiles.front().width, plan.tiles.front().height);
    return {{}, {}, plan.factor * pixels + 2};
}

/// Whether what samples see of endless ground is found without OpenGL.
bool sees_in_buffer(const View& view, const TilePlan& plan) {
    return view.look.ground == Ground::endless && !view.camera.has_lens() &&
           view.camera.projection == Projection::perspective && SeenBuffer::holds(samples_of(plan));
}

/// Of the pixels of a tile, where endless ground is coloured by them.
std::optional<gl::DepthBuffer> depths_of_pixels(const View& view, const TilePlan& plan) {
    if (!sees_in_buffer(view, plan) || plan.factor == 1) return std::nullopt;
    return gl::DepthBuffer(plan.tiles.front().width, plan.tiles.front().height);
}

gl::Constants constants_of(const View& view, const Light& light, const Block& ground,
                           PixelKind kind, const TilePlan& plan) {
    gl::Constants fixed = fixed_uniforms(view, light, ground, kind);
    fixed.push_back({"samples_in_buffer", sees_in_buffer(view, plan) ? 1.0F : 0.0F});
    return fixed;
}

constexpr GLbitfield everything = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;

}  // namespace

Snapshot Renderer::Parts::shown_first(const Snapshot& first, const View& view) {
    std::optional<Snapshot> shown = shown_snapshot(first, view);
    return shown ? *std::move(shown) : first;
}

Renderer::Parts::Parts(gl::Context& context_, const View& view_, const Snapshot& first_,
                       std::int64_t last_step_, WorkerPool& pool_, const RenderLimits& limits,
                       PixelKind kind_)
    : context(context_),
      view(with_chosen_ground(view_, first_)),
      first(shown_first(drawable(first_), view)),
      last_step(last_step_),
      pool(pool_),
      wanted(kind_),
      kind(lens() ? PixelKind::radiance : kind_),
      block(framed_block(view, first)),
      plain(plain_of(view, first, pool)),
      first_in_plain(plain ? std::optional(plain->around(first)) : std::nullopt),
      ground(plain ? plain->ground_of(block) : block),
      water(draws_water(view.look, first)),
      refinement(chosen_refinement(view, first, first_ground(), limits.draft)),
      origin(view.look.ground == Ground::endless && !plain
                 ? origin_around(camera_at(0), block, first.bed.nx(), first.bed.ny())
                 : DrawnOrigin{}),
      copies(far_copies_of(view, block, first)),
      plan(plan_of(view, limits)),
      light(light_of_view(view)),
      atmosphere(light.atmosphere),
      light_before(light),
      sun_before(view.sun),
      fixed(constants_of(view, light, ground, kind, plan)),
      sky(light.sky_columns, light.sky_rows, sky_layout, light.sky_texels.data()),
      shading(view, ground, first_ground(), display_bed(first_ground(), ground, refinement),
              static_cast<int>(std::max(view.image.width, view.image.height) *
                               view.image.supersampling),
              fixed, mipmaps, kind),
      terrain(view, block, fixed, shades_water_by_pixel(view, first)),
      background(view, block, light, floor_of(view, first, block, refinement, pool), fixed, wanted),
      pixel_depths(depths_of_pixels(view, plan)),
      one_picture(limits.one_picture),
      later_pictures(!limits.one_picture) {
    if (shades_water_by_pixel(view, first))
        water_pixels.emplace(plan, fixed, kind, limits.pixels_alike);
    if (plain) plain->stand_in(view.camera, *first_in_plain, block);
    if (view.look.ground == Ground::endless) {
        world.emplace(view, ground, first_ground(), refinement, origin, copies, fixed, mipmaps,
                      sees_in_buffer(view, plan));
        if (pixel_depths) {
            const Tile& tile = plan.tiles.front();
            pixels.emplace(tile.width, tile.height, nearest_layout(kind), &*pixel_depths);
        }
    }
    if (first.section)
        air.emplace(block, camera_at(0),
                    static_cast<int>(std::max(view.image.width, view.image.height)), fixed,
                    mipmaps);
    if (draws_plants(view, first)) plants.emplace(view, ground, fixed);
    if (!view.persons.empty()) persons.emplace(view, block, first, fixed);
    if (!view.tracks.empty()) tracks.emplace(view, block, first, fixed);
    if (world && view.streamers.strength > 0.0)
        streamers.emplace(view, block, plan.tiles.front().width, plan.tiles.front().height);
    gl::check_errors("the renderer's setup");
}

GroundTransform Renderer::Parts::plant_ground(const Camera& camera) const {
    if (world)
        return {world->clip_from_eye(camera),  true, world->curvature(), origin.place, copies,
                world->eye_from_middle(camera)};
    return {glm::mat4(clip_matrix(camera)), false, 0.0F, glm::dvec2(0.0), {}, glm::dvec2(0.0)};
}

Camera Renderer::Parts::camera_at(std::int64_t step) const {
    return camera_at_step(view, block, step, last_step);
}

Field<float> Renderer::Parts::drawn_surface(const ReadyPicture& picture) const {
    if (world)
        return rolled(picture.lit->heights->finest(), -refinement * origin.east,
                      -refinement * origin.north);
    const LitBed& lit = *picture.lit;
    return lit.water ? surface_of(lit.bed, *lit.water, picture.shown()) : lit.bed.z;
}

Field<float> Renderer::Parts::drawn_depth(const DisplayWater& standing,
                                          const Snapshot& shown) const {
    const auto rise = static_cast<float>(block.height_scale / shown.scale.height_unit);
    Field<float> depth = standing.depth;
    for (float& metres : depth.values()) metres = rise * std::max(metres, 0.0F);
    return depth;
}

Field<float> Renderer::Parts::surface_of(const DisplayBed& bed, const DisplayWater& standing,
                                         const Snapshot& shown) const {
    Field<float> surface = drawn_depth(standing, shown);
    for (std::size_t i = 0; i < surface.size(); ++i) surface.values()[i] += bed.z.values()[i];
    return surface;
}

glm::ivec2 Renderer::Parts::first_sample(const Tile& tile) const {
    const int bottom = static_cast<int>(view.image.height) - tile.y - tile.height;
    return glm::ivec2(tile.x, bottom) * plan.factor;
}

glm::ivec2 Renderer::Parts::target_corner(const Tile& tile) const {
    const glm::ivec2 kept = first_sample(tile);
    return {plan.target_begin(kept.x), plan.target_begin(kept.y)};
}

void Renderer::Parts::draw_tile(const Tile& tile, const Camera& camera, Image& image) {
    gl::functions().BindVertexArray(no_attributes.name());
    if (coloured_by_pixels(camera)) {
        draw_block(tile, camera, image);
        return;
    }
    const bool seen_behind = !image.transparent();
    const bool ground_first = (pixels && !air) || streamers;
    if (seen_behind && !ground_first) draw_background(tile, camera, nullptr);
    packs_samples() ? draw_packed_samples(tile, camera) : draw_samples(tile, camera);
    if (seen_behind && ground_first) draw_uncovered_background(tile, camera);
    if (packs_samples()) {
        bytes.resolve(tile, plan.factor, *packed, pool, image);
        return;
    }
    sampled->colours->bind();
    bytes.resolve(tile, plan.factor, first_sample(tile) - target_corner(tile), pool, image);
}

void Renderer::Parts::draw_tile(const Tile& tile, const Camera& camera, DeepPicture& picture) {
    gl::functions().BindVertexArray(no_attributes.name());
    if (!open() && !streamers) draw_background(tile, camera, &picture);
    draw_samples(tile, camera);
    if (streamers) draw_background(tile, camera, &picture);
    sampled->colours->bind();
    picture.resolve(tile, plan.factor, first_sample(tile) - target_corner(tile), pool);
}

DeepPicture Renderer::Parts::deep_picture(const Camera& camera) {
    DeepPicture picture(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                        kind, open());
    for (const Tile& tile : plan.tiles) draw_tile(tile, camera, picture);
    return picture;
}

void Renderer::Parts::rasterise_positions(const Tile& tile, const Camera& camera,
                                          SurfacePositionLayers& layers) {
    const Tile& largest = plan.tiles.front();
    if (!places) places.emplace(largest.width, largest.height);
    const int bottom = static_cast<int>(view.image.height) - tile.y - tile.height;
    TileSamples placed{};
    placed.picture_size =
        glm::vec2(static_cast<float>(view.image.width), static_cast<float>(view.image.height));
    placed.corner = glm::vec2(static_cast<float>(tile.x), static_cast<float>(bottom));
    placed.size = glm::vec2(static_cast<float>(largest.width), static_cast<float>(largest.height));
    const gl::Functions& gl = gl::functions();
    places->target.bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(everything);
    if (world) {
        world->rasterise(camera, placed, false);
    } else {
        terrain.rasterise_positions(places->surface, places->sides, camera, placed);
    }
    if (plants) plants->rasterise_positions(places->leaves, plant_ground(camera), camera, placed);
    if (persons)
        persons->rasterise_positions(places->persons, plant_ground(camera), camera, placed);
    std::vector<float> texels(4 * static_cast<std::size_t>(tile.width) *
                              static_cast<std::size_t>(tile.height));
    gl.ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_FLOAT, texels.data());
    layers.add(tile, texels, pool);
}

TileSamples Renderer::Parts::placed_samples(const Tile& tile) const {
    TileSamples placed{};
    placed.picture_size =
        glm::vec2(static_cast<float>(view.image.width), static_cast<float>(view.image.height)) *
        static_cast<float>(plan.factor);
    placed.corner = glm::vec2(target_corner(tile));
    placed.size =
        glm::vec2(static_cast<float>(plan.target_width), static_cast<float>(plan.target_height));
    return placed;
}

PixelSamples Renderer::Parts::pixel_samples(const Tile& tile, const Camera& camera) const {
    const int below = static_cast<int>(view.image.height) - tile.y - tile.height;
    const int rows = world->rows_seen(camera, static_cast<int>(view.image.height)) - below;
    return {first_sample(tile) - target_corner(tile), plan.factor, std::clamp(rows, 0, tile.height),
            tile.width, tile.height};
}

void Renderer::Parts::see_ground(const Tile& tile, const Camera& camera) {
    if (world && world->in_buffer()) {
        const glm::ivec2 picture(static_cast<int>(view.image.width),
                                 static_cast<int>(view.image.height));
        world->rasterise_buffer(camera, pixel_samples(tile, camera), target_corner(tile),
                                plan.factor * picture, pool);
        if (packs_samples() && !streamers) return;
    }
    if (!sampled) sampled.emplace(plan, view.look.ground, water_pixels.has_value());
    sampled->visibility.bind();
    gl::functions().ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl::functions().Clear(everything);
    if (!world) {
        terrain.rasterise(camera, placed_samples(tile));
    } else if (world->in_buffer()) {
        world->copy_visibility(camera, pixel_samples(tile, camera));
    } else {
        world->rasterise(camera, placed_samples(tile));
    }
}

void Renderer::Parts::see_streamers(const Tile& tile, const Camera& camera) {
    if (!streamers) return;
    const glm::ivec2 corner = first_sample(tile) - target_corner(tile);
    const GroundTransform standing_on = plant_ground(camera);
    std::vector<StreamerLayer::Occluder> occluders;
    if (plants)
        occluders.emplace_back([&](const TileSamples& in_pixels) {
            plants->rasterise_depths(standing_on, camera, in_pixels);
        });
    if (persons)
        occluders.emplace_back([&](const TileSamples& in_pixels) {
            persons->rasterise_depths(standing_on, camera, in_pixels);
        });
    streamers->draw(sampled->visibility.colour(), corner, plan.factor, tile, light, camera,
                    occluders);
    if (plants) plants->set_streamers(&*streamers, corner, plan.factor);
    if (persons) persons->set_streamers(&*streamers, corner, plan.factor);
    world->set_streamers(&*streamers, corner);
}

void Renderer::Parts::shade_pixels(const PixelSamples& at, const Camera& camera) {
    pixels->bind();
    gl::functions().Clear(GL_COLOR_BUFFER_BIT);
    pixel_depths->set_stencils(at.columns, at.all_rows, world->kinds().numbers().data());
    world->shade_pixels(at, shading, light, camera);
}

void Renderer::Parts::draw_packed_samples(const Tile& tile, const Camera& camera) {
    if (!packed) packed.emplace(plan.factor);
    const PixelSamples at = pixel_samples(tile, camera);
    see_ground(tile, camera);
    see_streamers(tile, camera);
    const gl::Texture2D* seen = sampled ? &sampled->visibility.colour() : nullptr;
    shade_pixels(at, camera);
    packed->read_pixels(tile, at.first, world->kinds());
    world->shade_packed_samples(seen, *packed, shading, light, camera);
}

void Renderer::Parts::draw_samples(const Tile& tile, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    see_ground(tile, camera);
    see_streamers(tile, camera);
    if (!sampled->colours)
        sampled->colours.emplace(plan.target_width, plan.target_height, nearest_layout(kind),
                                 &sampled->depths);
    const gl::RenderTarget& seen = sampled->visibility;
    const gl::RenderTarget& samples = *sampled->colours;
    const TileSamples placed = placed_samples(tile);
    const glm::ivec2 offset = pixel_offset(first_sample(tile) - target_corner(tile), plan.factor);
    if (water_pixels) {
        gl.BindVertexArray(no_attributes.name());
        water_pixels->shade(seen.colour(), offset, {shading, terrain, light, camera}, placed);
    }
    samples.bind();
    gl.Clear(GL_COLOR_BUFFER_BIT);
    if (lens()) {
        if (!open()) draw_behind_samples(tile, camera);
    } else if (air) {
        gl.BindVertexArray(no_attributes.name());
        air->draw_behind(surroundings().colour(), plan.factor,
                         first_sample(tile) - target_corner(tile), {tile.width, tile.height});
    }
    if (world) {
        if (pixels) {
            const PixelSamples at = pixel_samples(tile, camera);
            shade_pixels(at, camera);
            samples.bind();
            world->upsample_pixels(pixels->colour(), at);
        }
        world->shade_samples(seen.colour(), shading, light, camera);
    } else {
        const gl::Texture2D& colours = water_pixels ? water_pixels->colours() : shading.colours();
        terrain.shade_samples(seen.colour(), colours, light, camera, placed, offset);
    }
    if (tracks)
        tracks->draw(seen.colour(), world ? &*world : nullptr, plant_ground(camera), shading, light,
                     camera, placed);
    if (plants) plants->draw(plant_ground(camera), shading, light, camera, placed);
    if (persons) persons->draw(plant_ground(camera), shading, light, camera, placed);
    if (air) air->draw(camera, placed);
}

void Renderer::Parts::set_light(const FramePose& pose) {
    if (pose.sun.azimuth != view.sun.azimuth || pose.sun.elevation != view.sun.elevation) {
        const bool again =
            pose.sun.azimuth == sun_before.azimuth && pose.sun.elevation == sun_before.elevation;
        std::swap(light, light_before);
        sun_before = view.sun;
        view.sun.azimuth = pose.sun.azimuth;
        view.sun.elevation = pose.sun.elevation;
        if (!again) light = light_of_view(view);
        sky.upload(light.sky_texels.data());
        background.set_floor(floor_of(view, first, block, refinement, pool));
    }
    light.stops = pose.exposure;
    light.cloud_shift = cloud_shift(view.air, pose.share);
}

void Renderer::Parts::follow_sky(const FramePose& pose) {
    if (view.sun.hours == 0.0 && view.air.cloud_drift == 0.0) return;
    context.make_current();
    set_light(pose);
    surroundings_from.reset();
}

}  // namespace fumon
