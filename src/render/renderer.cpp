#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
#include "render/byte_picture.h"
#include "render/deep_picture.h"
#include "render/light/floor_map.h"
#include "render/light/light.h"
#include "render/light/lighting.h"
#include "render/light/repeated_light.h"
#include "render/light/view_light.h"
#include "render/person_layer.h"
#include "render/place_layers.h"
#include "render/place_pass.h"
#include "render/plant_layer.h"
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

/// What lies dark on the plain around the block; nothing where no plain is drawn.
FloorMap floor_of(const View& view, const Snapshot& first, const Block& block, int refinement,
                  WorkerPool& pool) {
    const bool seen = view.look.mode == ViewMode::scenic && view.look.ground != Ground::endless &&
                      view.look.background != Background::transparent;
    if (!seen) return open_floor();
    return floor_map(display_bed(first, block, refinement), block, sun_direction(view.sun), pool);
}

/// Along each side of the shaded bed: finer ones want finer places than draw_kinds() has room for.
constexpr int most_texels_of_pixels = 2048;

const gl::TextureLayout kinds_layout{GL_R32UI, GL_RED_INTEGER,  GL_UNSIGNED_INT, GL_NEAREST,
                                     0,        GL_CLAMP_TO_EDGE};
const gl::TextureLayout squares_layout{GL_RGBA16,  GL_RGBA, GL_UNSIGNED_SHORT,
                                       GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};

gl::TextureLayout plain_layout(PixelKind kind) {
    gl::TextureLayout layout = colour_layout(kind);
    layout.filter = GL_NEAREST;
    return layout;
}

/// What samples see, and their colours.
struct SampleTargets {
    SampleTargets(const TilePlan& plan, Ground ground, PixelKind kind)
        : depths(plan.target_width, plan.target_height),
          seen(plan.target_width, plan.target_height, seen_layout(ground), &depths),
          colours(plan.target_width, plan.target_height, plain_layout(kind), &depths) {}

    gl::DepthBuffer depths;
    gl::RenderTarget seen;
    gl::RenderTarget colours;
};

/// What the samples of a block see, and the colours of its pixels.
struct BlockTargets {
    explicit BlockTargets(const TilePlan& plan)
        : depths(plan.target_width, plan.target_height),
          seen(plan.target_width, plan.target_height, kinds_layout, &depths),
          pixel_depths(plan.target_width / 2, plan.target_height / 2),
          pixels(plan.target_width / 2, plan.target_height / 2, squares_layout, &pixel_depths) {}

    gl::DepthBuffer depths;
    gl::RenderTarget seen;
    gl::DepthBuffer pixel_depths;
    gl::RenderTarget pixels;
};

}  // namespace

struct Renderer::Parts {
    Parts(gl::Context& context_, const View& view_, const Snapshot& first_, std::int64_t last_step_,
          WorkerPool& pool_, const RenderLimits& limits, PixelKind kind_);

    [[nodiscard]] Camera camera_at(std::int64_t step) const;
    /// A tile's first sample, and the sample its target begins at; from the picture's lower left.
    [[nodiscard]] glm::ivec2 first_sample(const Tile& tile) const;
    [[nodiscard]] glm::ivec2 target_corner(const Tile& tile) const;
    void set_light(const FramePose& pose);
    [[nodiscard]] bool open() const { return view.look.background == Background::transparent; }
    [[nodiscard]] TileSamples placed_samples(const Tile& tile) const;
    /// Whether pixels of the block get their colours as wholes, of 8 bits and in the scenic look.
    [[nodiscard]] bool coloured_by_pixels() const;
    void draw_pixels(const Tile& tile, const Camera& camera);
    void draw_samples(const Tile& tile, const Camera& camera);
    void draw_tile(const Tile& tile, const Camera& camera, Image& image);
    void draw_tile(const Tile& tile, const Camera& camera, DeepPicture& picture);
    void draw_places(const Tile& tile, const Camera& camera, PlaceLayers& layers);
    [[nodiscard]] DeepPicture deep_picture(const Camera& camera);
    void draw_background(const Tile& tile, const Camera& camera, DeepPicture* deep);
    [[nodiscard]] PlantGround plant_ground(const Camera& camera) const;
    [[nodiscard]] Field<float> drawn_surface(const Snapshot& snapshot, const Block& framed) const;

    gl::Context& context;
    View view;
    Snapshot first;
    std::int64_t last_step;
    WorkerPool& pool;
    PixelKind kind;
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
    std::optional<PersonLayer> persons;
    std::optional<PlacePass> places;
    std::optional<SampleTargets> sampled;
    std::optional<BlockTargets> block_targets;
    std::optional<gl::DepthBuffer> pixel_depths;
    std::optional<gl::RenderTarget> pixels;  // of endless ground, those that see one place each
    gl::RenderTarget surroundings;
    gl::VertexArray no_attributes;
    bool surroundings_drawn = false;
    BytePicture bytes;
};

Renderer::Parts::Parts(gl::Context& context_, const View& view_, const Snapshot& first_,
                       std::int64_t last_step_, WorkerPool& pool_, const RenderLimits& limits,
                       PixelKind kind_)
    : context(context_),
      view(with_chosen_ground(view_, first_)),
      first(shown_first(first_, view)),
      last_step(last_step_),
      pool(pool_),
      kind(kind_),
      block(framed_block(view, first)),
      water(draws_water(view.look, first)),
      refinement(refinement_of(first.bed.nx(), first.bed.ny(),
                               static_cast<int>(std::max(view.image.width, view.image.height)),
                               smooth_enough(view.look.ground))),
      plan(plan_of(view, limits)),
      light(light_of_view(view)),
      fixed(fixed_uniforms(view, light, block, kind)),
      sky(light.sky_columns, light.sky_rows, sky_layout, light.sky_texels.data()),
      shading(view, block, first, display_bed(first, block, refinement),
              static_cast<int>(std::max(view.image.width, view.image.height)) * plan.factor, fixed,
              kind),
      terrain(view, block, fixed),
      background(view, block, floor_of(view, first, block, refinement, pool), fixed),
      surroundings(plan.tiles.front().width, plan.tiles.front().height, plain_layout(kind)) {
    if (view.look.ground == Ground::endless) {
        world.emplace(view, block, first, refinement, fixed);
        if (plan.factor > 1) {
            const Tile& tile = plan.tiles.front();
            pixel_depths.emplace(tile.width, tile.height);
            pixels.emplace(tile.width, tile.height, plain_layout(kind), &*pixel_depths);
        }
    }
    if (first.section)
        air.emplace(block, camera_at(0),
                    static_cast<int>(std::max(view.image.width, view.image.height)), fixed);
    if (draws_plants(view, first)) plants.emplace(view, block, fixed);
    if (!view.persons.empty()) persons.emplace(view, block, first, fixed);
    gl::check_errors("the renderer's setup");
}

PlantGround Renderer::Parts::plant_ground(const Camera& camera) const {
    if (world) return {world->clip_from_eye(camera), true, world->curvature()};
    return {glm::mat4(clip_matrix(camera)), false, 0.0F};
}

Camera Renderer::Parts::camera_at(std::int64_t step) const {
    return camera_at_step(view, block, step, last_step);
}

Field<float> Renderer::Parts::drawn_surface(const Snapshot& snapshot, const Block& framed) const {
    if (world) return world->heights();
    Field<float> surface = display_bed(snapshot, framed, refinement).z;
    if (!water) return surface;
    const DisplayWater standing = display_water(snapshot, refinement);
    const auto rise = static_cast<float>(block.height_scale / snapshot.scale.height_unit);
    for (std::size_t i = 0; i < surface.size(); ++i)
        surface.values()[i] += rise * standing.depth.values()[i];
    return surface;
}

void Renderer::Parts::draw_background(const Tile& tile, const Camera& camera, DeepPicture* deep) {
    // Nothing in it changes while the camera stands still.
    const bool still = deep == nullptr && view.camera.turn == 0.0 && plan.tiles.size() == 1;
    if (still && surroundings_drawn) return;
    surroundings.bind();
    background.draw(light, camera, tile);
    if (deep != nullptr) {
        deep->read_background(tile);
    } else {
        bytes.read_background(tile);
    }
    surroundings_drawn = true;
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
    gl::functions().BindVertexArray(no_attributes.name());
    if (!image.transparent()) draw_background(tile, camera, nullptr);
    if (coloured_by_pixels()) {
        draw_pixels(tile, camera);
        bytes.read_pixels(tile, (first_sample(tile) - target_corner(tile)) / 2, pool, image);
        return;
    }
    draw_samples(tile, camera);
    sampled->colours.bind();
    bytes.resolve(tile, plan.factor, first_sample(tile) - target_corner(tile), pool, image);
}

void Renderer::Parts::draw_tile(const Tile& tile, const Camera& camera, DeepPicture& picture) {
    gl::functions().BindVertexArray(no_attributes.name());
    if (!open()) draw_background(tile, camera, &picture);
    draw_samples(tile, camera);
    sampled->colours.bind();
    picture.resolve(tile, plan.factor, first_sample(tile) - target_corner(tile), pool);
}

DeepPicture Renderer::Parts::deep_picture(const Camera& camera) {
    DeepPicture picture(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                        kind, open());
    for (const Tile& tile : plan.tiles) draw_tile(tile, camera, picture);
    return picture;
}

void Renderer::Parts::draw_places(const Tile& tile, const Camera& camera, PlaceLayers& layers) {
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
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (world) {
        world->draw_seen(camera, placed);
    } else {
        terrain.draw_places(places->surface, places->sides, camera, placed);
    }
    if (plants) plants->draw_places(places->leaves, plant_ground(camera), camera, placed);
    if (persons) persons->draw_places(places->persons, plant_ground(camera), camera, placed);
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

bool Renderer::Parts::coloured_by_pixels() const {
    const gl::Texture2D& colours = shading.colours();
    return kind == PixelKind::display_8 && view.look.mode == ViewMode::scenic && plan.factor == 2 &&
           !world && !air && !plants && !persons && !terrain.has_rim() &&
           std::max(colours.width(), colours.height()) <= most_texels_of_pixels;
}

void Renderer::Parts::draw_pixels(const Tile& tile, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    if (!block_targets) block_targets.emplace(plan);
    const TileSamples placed = placed_samples(tile);
    block_targets->seen.bind();
    const std::array<GLuint, 4> nothing{};
    gl.ClearBufferuiv(GL_COLOR, 0, nothing.data());
    gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    terrain.draw_kinds(camera, placed);
    block_targets->pixels.bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    terrain.colour_pixels(block_targets->seen.colour(), shading.colours(), light, camera,
                          {0.5F * placed.picture_size, 0.5F * placed.corner, 0.5F * placed.size});
}

void Renderer::Parts::draw_samples(const Tile& tile, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    if (!sampled) sampled.emplace(plan, view.look.ground, kind);
    const gl::RenderTarget& seen = sampled->seen;
    const gl::RenderTarget& samples = sampled->colours;
    const TileSamples placed = placed_samples(tile);
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
    if (persons) persons->draw(plant_ground(camera), shading, light, camera, placed);
    if (air) air->draw(camera, placed);
}

Renderer::Renderer(gl::Context& context, const View& view, const Snapshot& first,
                   std::int64_t last_step, WorkerPool& pool, const RenderLimits& limits,
                   PixelKind kind) {
    context.make_current();
    parts_ = std::make_unique<Parts>(context, view, first, last_step, pool, limits, kind);
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
    const Camera camera = above_ground(p.camera_at(snapshot.step), framed, snapshot);
    prepare(snapshot, p.first, framed, camera);
    return draw(camera);
}

LayeredImage Renderer::render_layers(const Snapshot& whole, bool places) {
    Parts& p = *parts_;
    const std::optional<Snapshot> reshaped = shown_snapshot(whole, p.view);
    const Snapshot& snapshot = reshaped ? *reshaped : whole;
    const Block framed = block_of_frame(p.block, p.view.look, p.first, snapshot);
    const Camera camera = above_ground(p.camera_at(snapshot.step), framed, snapshot);
    prepare(snapshot, p.first, framed, camera);
    LayeredImage image;
    image.width = static_cast<int>(p.view.image.width);
    image.height = static_cast<int>(p.view.image.height);
    set_matrices(image, framed, camera);
    image.layers = p.deep_picture(camera).take_channels();
    if (places) {
        const bool plain = !p.world && !p.open() && p.view.look.mode == ViewMode::scenic;
        PlaceLayers layers(image.width, image.height,
                           {snapshot, framed, camera, p.drawn_surface(snapshot, framed),
                            p.world.has_value(), plain});
        for (const Tile& tile : p.plan.tiles) p.draw_places(tile, camera, layers);
        for (ImageLayer& layer : layers.take()) image.layers.push_back(std::move(layer));
    }
    gl::check_errors("a picture's layers");
    return image;
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
    prepare(snapshot, reference ? *reference : p.first,
            block_of_frame(p.block, p.view.look, p.first, snapshot), pose.camera);
    return draw(pose.camera);
}

void Renderer::Parts::set_light(const FramePose& pose) {
    if (pose.sun.azimuth != view.sun.azimuth || pose.sun.elevation != view.sun.elevation) {
        view.sun.azimuth = pose.sun.azimuth;
        view.sun.elevation = pose.sun.elevation;
        light = light_of_view(view);
        sky.upload(light.sky_texels.data());
        background.set_floor(floor_of(view, first, block, refinement, pool));
    }
    light.stops = pose.exposure;
}

void Renderer::prepare(const Snapshot& snapshot, const Snapshot& reference, const Block& framed,
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
        if (p.persons) p.persons->set_bed(light.z, true);
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
        if (p.persons) p.persons->set_bed(bed.z, false);
        p.terrain.set_clarity(rise * static_cast<float>(p.shading.clarity()));
    }
    if (p.air && snapshot.section) p.air->set_air(snapshot, framed, camera, p.pool);

    if (p.world)
        p.world->look_from(camera, static_cast<double>(p.view.image.height) * p.plan.factor,
                           p.pool);
    if (p.plants) p.plants->choose(p.plant_ground(camera), camera);
}

Image Renderer::draw(const Camera& camera) {
    Parts& p = *parts_;
    const bool open = p.open();
    if (p.kind == PixelKind::display_16) {
        Image image = p.deep_picture(camera).display();
        gl::check_errors("a frame");
        return image;
    }
    Image image(static_cast<int>(p.view.image.width), static_cast<int>(p.view.image.height));
    if (open) image = with_alpha(std::move(image));
    for (const Tile& tile : p.plan.tiles) p.draw_tile(tile, camera, image);
    if (open) spread_colours(image);
    gl::check_errors("a frame");
    return image;
}

}  // namespace fumon
