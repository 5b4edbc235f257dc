#include "render/renderer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "gl/functions.h"
#include "render/light/lighting.h"
#include "render/light/repeated_light.h"
#
#include "render/renderer_parts.h"
#include "render/view/chosen_ground.h"
#include "render/view/display_bed.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

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
    if (pose.reference != nullptr) reference = Parts::shown_first(*pose.reference, p.view);
    prepare(snapshot, reference ? *reference : p.first,
            block_of_frame(p.block, p.view.look, p.first, snapshot), pose.camera);
    return draw(pose.camera);
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
