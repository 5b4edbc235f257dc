#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "gl/functions.h"
#include "render/air_layer.h"
#include "render/background_layer.h"
#include "render/bed_shading.h"
#include "render/light/floor_map.h"
#include "render/light/light.h"
#include "render/light/lighting.h"
#include "render/light/repeated_light.h"
#include "render/plant_layer.h"
#include "render/sample_vectors.h"
#include "render/terrain_layer.h"
#include "render/tiles.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/chosen_ground.h"
#include "render/view/display_bed.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"
#include "render/world_layer.h"

namespace fumon {

namespace {

constexpr int samples_in_a_band = 1 << 18;  // read at once: 1 MiB

Snapshot shown_first(const Snapshot& first, const View& view) {
    std::optional<Snapshot> shown = shown_snapshot(first, view);
    return shown ? *std::move(shown) : first;
}

/// Cells along the bed's longer side from which on it is drawn as it is. On endless ground one may
/// stand.
int smooth_enough(Ground ground) {
    return ground == Ground::endless ? 1000 : 400;
}

TilePlan plan_of(const View& view, const RenderLimits& limits) {
    GLint largest = 0;
    gl::functions().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return plan_tiles(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                      static_cast<int>(view.image.supersampling),
                      std::min(limits.tile_samples, static_cast<int>(largest)));
}

const gl::TextureLayout sky_layout{GL_RGB32F, GL_RGB, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};

Light light_of(const View& view) {
    const bool needed = view.look.ground == Ground::endless ||
                        view.sun.source == LightSource::moon || view.air.planet != Planet::earth;
    const bool atmosphere =
        view.look.sky == SkyModel::atmosphere || (view.look.sky == SkyModel::automatic && needed);
    if (view.look.sky == SkyModel::overcast && view.look.mode == ViewMode::scenic)
        return make_overcast_light(view.sun);
    if (!atmosphere || view.look.mode != ViewMode::scenic) return make_light(view.sun);
    return make_atmospheric_light(view.sun, view.air.planet);
}

/// Of what a sample sees: a place on the block, or an offset from the eye over endless ground.
gl::TextureLayout seen_layout(Ground ground) {
    gl::TextureLayout layout{GL_RG16, GL_RG, GL_UNSIGNED_SHORT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    if (ground == Ground::endless)
        layout = {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
    return layout;
}

bool draws_plants(const View& view, const Snapshot& first) {
    return view.look.plants > 0.0 && view.look.mode == ViewMode::scenic &&
           view.camera.projection == Projection::perspective &&
           (find_named(first.fields, "grass") != nullptr ||
            find_named(first.fields, "shrubs") != nullptr);
}

gl::TextureLayout plain_layout() {
    gl::TextureLayout layout;
    layout.filter = GL_NEAREST;
    return layout;
}

}  // namespace

struct Renderer::Parts {
    Parts(gl::Context& context_, const View& view_, const Snapshot& first_, std::int64_t last_step_,
          WorkerPool& pool_, const RenderLimits& limits);

    [[nodiscard]] Camera camera_at(std::int64_t step) const;
    /// A tile's first sample, and the sample its target begins at; from the picture's lower left.
    [[nodiscard]] glm::ivec2 first_sample(const Tile& tile) const;
    [[nodiscard]] glm::ivec2 target_corner(const Tile& tile) const;
    void set_light(const FramePose& pose);
    void draw_tile(const Tile& tile, const Camera& camera, Image& image);
    void draw_background(const Tile& tile, const Camera& camera);
    void read_background(const Tile& tile);
    void resolve(const Tile& tile, Image& image);
    [[nodiscard]] PlantGround plant_ground(const Camera& camera) const;

    gl::Context& context;
    View view;
    Snapshot first;
    std::int64_t last_step;
    WorkerPool& pool;
    Block block;
    bool water;  // whether it is drawn
    int refinement;
    TilePlan plan;
    Light light;
    gl::Constants fixed;
    gl::Texture2D sky;
    BedShading shading;
    TerrainLayer terrain;
    BackgroundLayer background;
    std::optional<AirLayer> air;
    std::optional<WorldLayer> world;  // where the bed is endless
    std::optional<PlantLayer> plants;
    gl::DepthBuffer depths;
    gl::RenderTarget seen;  // what each sample sees of the ground
    std::optional<gl::DepthBuffer> pixel_depths;
    std::optional<gl::RenderTarget> pixels;  // of endless ground, those that see one place each
    gl::RenderTarget samples;
    gl::RenderTarget surroundings;
    gl::VertexArray no_attributes;
    bool surroundings_drawn = false;
    std::vector<ColourPlanes> behind;         // rows of the surroundings, the upper first
    std::vector<std::uint32_t> samples_read;  // those of a few rows of pixels
};

Renderer::Parts::Parts(gl::Context& context_, const View& view_, const Snapshot& first_,
                       std::int64_t last_step_, WorkerPool& pool_, const RenderLimits& limits)
    : context(context_),
      view(with_chosen_ground(view_, first_)),
      first(shown_first(first_, view)),
      last_step(last_step_),
      pool(pool_),
      block(framed_block(view, first)),
      water(draws_water(view.look, first)),
      refinement(refinement_of(first.bed.nx(), first.bed.ny(),
                               static_cast<int>(std::max(view.image.width, view.image.height)),
                               smooth_enough(view.look.ground))),
      plan(plan_of(view, limits)),
      light(light_of(view)),
      fixed(fixed_uniforms(view, light, block)),
      sky(light.sky_columns, light.sky_rows, sky_layout, light.sky_texels.data()),
      shading(view, block, first, display_bed(first, block, refinement),
              static_cast<int>(std::max(view.image.width, view.image.height)) * plan.factor, fixed),
      terrain(view, block, fixed),
      background(
          view, block,
          floor_map(display_bed(first, block, refinement), block, sun_direction(view.sun), pool),
          fixed),
      depths(plan.target_width, plan.target_height),
      seen(plan.target_width, plan.target_height, seen_layout(view.look.ground), &depths),
      samples(plan.target_width, plan.target_height, plain_layout(), &depths),
      surroundings(plan.tiles.front().width, plan.tiles.front().height, plain_layout()) {
    if (view.look.ground == Ground::endless) {
        world.emplace(view, block, first, refinement, fixed);
        if (plan.factor > 1) {
            const Tile& tile = plan.tiles.front();
            pixel_depths.emplace(tile.width, tile.height);
            pixels.emplace(tile.width, tile.height, plain_layout(), &*pixel_depths);
        }
    }
    if (first.section)
        air.emplace(block, camera_at(0),
                    static_cast<int>(std::max(view.image.width, view.image.height)));
    if (draws_plants(view, first)) plants.emplace(view, block, fixed);
    gl::check_errors("the renderer's setup");
}

PlantGround Renderer::Parts::plant_ground(const Camera& camera) const {
    if (world) return {world->clip_from_eye(camera), true, world->curvature()};
    return {glm::mat4(clip_matrix(camera)), false, 0.0F};
}

Camera Renderer::Parts::camera_at(std::int64_t step) const {
    return camera_at_step(view, block, step, last_step);
}

void Renderer::Parts::draw_background(const Tile& tile, const Camera& camera) {
    // Nothing in it changes while the camera stands still.
    const bool still = view.camera.turn == 0.0 && plan.tiles.size() == 1;
    if (still && surroundings_drawn) return;
    surroundings.bind();
    background.draw(light, camera, tile);
    read_background(tile);
    surroundings_drawn = true;
}

void Renderer::Parts::read_background(const Tile& tile) {
    const auto width = static_cast<std::size_t>(tile.width);
    std::vector<std::uint8_t> rgba(4 * width * static_cast<std::size_t>(tile.height));
    gl::functions().ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE,
                               rgba.data());
    behind.assign(static_cast<std::size_t>(tile.height), ColourPlanes(tile.width));
    const std::uint8_t* pixel = rgba.data();
    for (ColourPlanes& row : behind) {
        for (std::size_t x = 0; x < width; ++x, pixel += 4) {
            row.red[x] = pixel[0];
            row.green[x] = pixel[1];
            row.blue[x] = pixel[2];
        }
    }
}

/// Reads the samples a few rows of pixels at a time, so that they stay in the cache.
void Renderer::Parts::resolve(const Tile& tile, Image& image) {
    const int columns = tile.width * plan.factor;
    const auto length = static_cast<std::size_t>(columns);
    const int band = std::max(1, samples_in_a_band / (columns * plan.factor));  // rows of pixels
    samples_read.resize(length * static_cast<std::size_t>(band * plan.factor) +
                        RowOfSamples::samples_read_beyond);
    const glm::ivec2 from = first_sample(tile) - target_corner(tile);
    samples.bind();
    for (int upper = 0; upper < tile.height; upper += band) {
        const int rows = std::min(band, tile.height - upper);
        const int lowest = from.y + (tile.height - upper - rows) * plan.factor;
        gl::functions().ReadPixels(from.x, lowest, columns, rows * plan.factor, GL_RGBA,
                                   GL_UNSIGNED_INT_8_8_8_8_REV, samples_read.data());
        pool.for_ranges(rows, [&](int begin, int end) {
            RowOfSamples row(tile.width, plan.factor);
            for (int y = begin; y < end; ++y) {
                const auto above = static_cast<std::size_t>((rows - 1 - y) * plan.factor);
                for (int j = 0; j < plan.factor; ++j)
                    row.add(samples_read.data() + length * (above + static_cast<std::size_t>(j)));
                const int in_tile = upper + y;
                const auto first_of_row = static_cast<std::size_t>(tile.y + in_tile) *
                                              static_cast<std::size_t>(image.width) +
                                          static_cast<std::size_t>(tile.x);
                if (image.transparent()) {
                    row.finish_open(image.rgb.data() + 3 * first_of_row,
                                    image.alpha.data() + first_of_row);
                    continue;
                }
                row.finish(behind[static_cast<std::size_t>(in_tile)],
                           image.rgb.data() + 3 * first_of_row);
            }
        });
    }
}

glm::ivec2 Renderer::Parts::first_sample(const Tile& tile) const {
    const int bottom = static_cast<int>(view.image.height) - tile.y - tile.height;
    return glm::ivec2(tile.x, bottom) * plan.factor;
}

glm::ivec2 Renderer::Parts::target_corner(const Tile& tile) const {
    const auto aligned = [&](int sample) {
        return static_cast<int>(
            std::floor(static_cast<double>(sample - plan.margin) / plan.alignment) *
            plan.alignment);
    };
    const glm::ivec2 kept = first_sample(tile);
    return {aligned(kept.x), aligned(kept.y)};
}

void Renderer::Parts::draw_tile(const Tile& tile, const Camera& camera, Image& image) {
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(no_attributes.name());
    if (!image.transparent()) draw_background(tile, camera);

    TileSamples placed{};
    placed.picture_size =
        glm::vec2(static_cast<float>(view.image.width), static_cast<float>(view.image.height)) *
        static_cast<float>(plan.factor);
    placed.corner = glm::vec2(target_corner(tile));
    placed.size =
        glm::vec2(static_cast<float>(plan.target_width), static_cast<float>(plan.target_height));
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    constexpr GLbitfield everything =
        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    seen.bind();
    gl.Clear(everything);
    if (world) {
        world->draw_seen(camera, placed);
    } else {
        terrain.draw_seen(camera, placed);
    }
    samples.bind();
    gl.Clear(GL_COLOR_BUFFER_BIT);
    if (air) {
        gl.BindVertexArray(no_attributes.name());
        air->draw_behind(surroundings.colour(), plan.factor,
                         first_sample(tile) - target_corner(tile), {tile.width, tile.height});
    }
    if (world) {
        if (pixels) {
            const PixelSamples at{first_sample(tile) - target_corner(tile), plan.factor};
            pixels->bind();
            gl.Clear(everything);
            world->colour_pixels(seen.colour(), at, shading, light, camera);
            samples.bind();
            world->spread_pixels(pixels->colour(), at);
        }
        world->colour_seen(seen.colour(), shading, light, camera);
    } else {
        terrain.colour_seen(seen.colour(), shading.colours(), light, camera, placed);
    }
    if (plants) plants->draw(plant_ground(camera), shading, light, camera, placed);
    if (air) air->draw(camera, placed);

    resolve(tile, image);
}

Renderer::Renderer(gl::Context& context, const View& view, const Snapshot& first,
                   std::int64_t last_step, WorkerPool& pool, const RenderLimits& limits) {
    context.make_current();
    parts_ = std::make_unique<Parts>(context, view, first, last_step, pool, limits);
}

Renderer::~Renderer() = default;

double Renderer::exaggeration() const {
    return parts_->block.exaggeration;
}

std::pair<double, double> Renderer::colour_range() const {
    return parts_->shading.range();
}

Image Renderer::render(const Snapshot& whole) {
    Parts& p = *parts_;
    const std::optional<Snapshot> reshaped = shown_snapshot(whole, p.view);
    const Snapshot& snapshot = reshaped ? *reshaped : whole;
    const Block framed = block_of_frame(p.block, p.view.look, p.first, snapshot);
    return draw(snapshot, p.first, framed,
                above_ground(p.camera_at(snapshot.step), framed, snapshot));
}

Image Renderer::render(const Snapshot& whole, const FramePose& pose) {
    Parts& p = *parts_;
    const std::optional<Snapshot> reshaped = shown_snapshot(whole, p.view);
    const Snapshot& snapshot = reshaped ? *reshaped : whole;
    p.context.make_current();
    p.set_light(pose);
    p.surroundings_drawn = false;
    std::optional<Snapshot> reference;
    if (pose.reference != nullptr) reference = shown_first(*pose.reference, p.view);
    return draw(snapshot, reference ? *reference : p.first,
                block_of_frame(p.block, p.view.look, p.first, snapshot), pose.camera);
}

void Renderer::Parts::set_light(const FramePose& pose) {
    if (pose.sun.azimuth != view.sun.azimuth || pose.sun.elevation != view.sun.elevation) {
        view.sun.azimuth = pose.sun.azimuth;
        view.sun.elevation = pose.sun.elevation;
        light = light_of(view);
        sky.upload(light.sky_texels.data());
        background.set_floor(
            floor_map(display_bed(first, block, refinement), block, sun_direction(view.sun), pool));
    }
    light.stops = pose.exposure;
}

Image Renderer::draw(const Snapshot& snapshot, const Snapshot& reference, const Block& framed,
                     const Camera& camera) {
    Parts& p = *parts_;
    if (snapshot.bed.nx() != p.first.bed.nx() || snapshot.bed.ny() != p.first.bed.ny())
        throw Error("a snapshot of another size than the first one cannot be drawn");
    p.context.make_current();
    const SunDirection sun = sun_direction(p.view.sun);
    std::optional<DisplayWater> water;
    if (p.water) water = display_water(snapshot, p.refinement);

    gl::functions().BindVertexArray(p.no_attributes.name());
    if (p.world) {
        const RepeatedLight light =
            repeated_light(snapshot, framed, p.refinement, sun, prevailing_way(snapshot), p.pool);
        p.shading.upload(snapshot, reference, light);
        p.world->set_bed(snapshot, light);
        if (p.plants) p.plants->set_bed(snapshot, light.z, true);
        p.sky.bind(sky_unit);
        p.shading.shade(p.light, camera);
    } else {
        const DisplayBed bed = display_bed(snapshot, framed, p.refinement);
        p.shading.upload(snapshot, reference, lighting_texels(bed, sun, p.pool),
                         water ? &*water : nullptr);
        p.sky.bind(sky_unit);
        p.shading.shade(p.light, camera);
        const auto rise = static_cast<float>(p.block.height_scale / snapshot.scale.height_unit);
        if (water) {
            for (float& depth : water->depth.values()) depth *= rise;
        }
        p.terrain.set_bed(bed, water ? &water->depth : nullptr, camera);
        if (p.plants) p.plants->set_bed(snapshot, bed.z, false);
        p.terrain.set_clarity(rise * static_cast<float>(p.shading.clarity()));
    }
    if (p.air && snapshot.section) p.air->set_air(snapshot, framed, camera, p.pool);

    if (p.world)
        p.world->look_from(camera, static_cast<double>(p.view.image.height) * p.plan.factor,
                           p.pool);
    if (p.plants) p.plants->choose(p.plant_ground(camera), camera);
    Image image(static_cast<int>(p.view.image.width), static_cast<int>(p.view.image.height));
    const bool open = p.view.look.background == Background::transparent;
    if (open) image = with_alpha(std::move(image));
    for (const Tile& tile : p.plan.tiles) p.draw_tile(tile, camera, image);
    if (open) spread_colours(image);
    gl::check_errors("a frame");
    return image;
}

}  // namespace fumon
