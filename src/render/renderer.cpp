#include "render/renderer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "gl/functions.h"
#include "render/frame/view_uniforms.h"
#include "render/ready_picture.h"
#include "render/renderer_parts.h"
#include "render/view/shown_snapshot.h"
#include "scene/placed_sun.h"

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

void Renderer::keep_colours() {
    parts_->shading.keep_range();
}

const DrawnColours& Renderer::drawn_colours() const {
    return parts_->shading.range();
}

ReadyPicture Renderer::ready(std::shared_ptr<const Snapshot> snapshot, const FramePose& pose,
                             const std::shared_ptr<const LitBed>& before, WorkerPool& pool) const {
    SunSettings sun = pose.sun;
    sun.diameter = parts_->view.sun.diameter;
    ReadyPicture picture =
        parts_->ready(std::move(snapshot), sun_direction(sun), pose, before, pool);
    picture.sun_share = parts_->sun_share(picture);
    return picture;
}

ReadyPicture Renderer::ready_at_step(const Snapshot& snapshot) const {
    const std::shared_ptr<const Snapshot> lent(std::shared_ptr<const Snapshot>(), &snapshot);
    const double share = share_of_run(snapshot.step, parts_->last_step);
    const SunSettings sun = sun_at(parts_->view.sun, share);
    ReadyPicture picture =
        parts_->ready(lent, sun_direction(sun), std::nullopt, nullptr, parts_->pool);
    picture.pose.sun = sun;
    picture.pose.share = share;
    picture.sun_share = parts_->sun_share(picture);
    return picture;
}

Image Renderer::render(const Snapshot& snapshot) {
    const ReadyPicture picture = ready_at_step(snapshot);
    parts_->follow_sky(picture.pose);
    prepare(picture);
    parts_->uploaded.reset();  // no later picture is of this snapshot
    return draw(picture);
}

LayeredImage Renderer::render_layers(const Snapshot& whole, bool places) {
    Parts& p = *parts_;
    const ReadyPicture picture = ready_at_step(whole);
    const Camera& camera = picture.pose.camera;
    p.follow_sky(picture.pose);
    prepare(picture);
    p.uploaded.reset();
    LayeredImage image;
    image.width = static_cast<int>(p.view.image.width);
    image.height = static_cast<int>(p.view.image.height);
    set_matrices(image, picture.framed, camera);
    image.layers = p.lens() ? p.lens_channels(camera, picture.lens_points)
                            : p.deep_picture(camera).take_channels();
    if (places) {
        const bool plain = !p.world && !p.open() && p.view.look.mode == ViewMode::scenic;
        SurfacePositionLayers layers(
            image.width, image.height,
            {picture.shown(), picture.framed,
             p.plain ? p.plain->ground_of(picture.framed) : picture.framed, camera,
             p.drawn_surface(picture), p.copies, p.world.has_value(), plain});
        for (const Tile& tile : p.plan.tiles) p.rasterise_positions(tile, camera, layers);
        for (ImageLayer& layer : layers.take()) image.layers.push_back(std::move(layer));
    }
    gl::check_errors("a picture's layers");
    return image;
}

Image Renderer::render(const ReadyPicture& picture) {
    Parts& p = *parts_;
    p.context.make_current();
    p.set_light(picture.pose);
    p.surroundings_from.reset();
    p.later_pictures = false;  // the camera moves
    prepare(picture);
    return draw(picture);
}

void Renderer::prepare(const ReadyPicture& picture) {
    Parts& p = *parts_;
    p.context.make_current();
    const Snapshot& snapshot = picture.shown();
    const LitBed& lit = *picture.lit;
    const Camera& camera = picture.pose.camera;
    std::optional<Snapshot> other;
    if (picture.pose.reference)
        other = Parts::shown_first(drawable(*picture.pose.reference), p.view);
    if (other && p.plain) other = PlainAround(*other, p.pool).around(*other);
    const Snapshot& reference = other ? *other : p.first_ground();
    const bool uploaded = p.uploaded == picture.lit && !other;
    p.uploaded = other ? nullptr : picture.lit;

    p.light.metered = metered_exposure(p.view, p.light, picture.pose.metered.value_or(camera));
    gl::functions().BindVertexArray(p.no_attributes.name());
    if (p.world) {
        if (!uploaded) {
            p.shading.upload(picture.ground_shown(), reference, lit.light, p.origin);
            p.world->set_bed(snapshot, lit.light, lit.heights);
            if (p.plants && p.plain) {
                // Those of the plain beyond the bed's tile are its tint alone.
                const Field<float>& maps = lit.heights->finest();
                Field<float> tile(maps.nx() / 2, maps.ny());
                for (int y = 0; y < tile.ny(); ++y)
                    std::copy_n(maps.row(y).begin(), tile.nx(), tile.row(y).begin());
                p.plants->set_bed(p.plain->own_tile(*lit.in_plain), tile, false);
            } else if (p.plants) {
                p.plants->set_bed(snapshot, lit.heights->finest(), true);
            }
            if (p.persons) p.persons->set_bed(lit.heights->finest(), p.ground, true);
            if (p.tracks)
                p.tracks->set_bed(lit.heights->finest(), p.ground, true, p.plant_ground(camera),
                                  nullptr);
        }
        p.sky.bind(sky_unit);
        if (!uploaded) p.shading.shade(p.light, camera);
        p.world->look_at(picture.ground);
    } else {
        p.shading.upload(snapshot, reference, lit.texels, lit.water ? &*lit.water : nullptr);
        p.sky.bind(sky_unit);
        p.shading.shade(p.light, camera);
        std::optional<Field<float>> depth;
        if (lit.water) depth = p.drawn_depth(*lit.water, snapshot);
        const Field<float>* standing = depth ? &*depth : nullptr;
        p.terrain.set_bed(lit.bed, standing, camera);
        if (p.water_pixels && p.coloured_by_pixels(camera))
            p.find_water_kinds(*lit.water, snapshot);
        if (p.plants) p.plants->set_bed(snapshot, lit.bed.z, false);
        if (p.persons) p.persons->set_bed(lit.bed.z, p.block, false);
        if (p.tracks) p.tracks->set_bed(lit.bed.z, p.block, false, {}, standing);
        const auto rise = static_cast<float>(p.block.height_scale / snapshot.scale.height_unit);
        p.terrain.set_clarity(rise * static_cast<float>(p.shading.clarity()));
    }
    p.block_coloured = false;
    p.see_sun(picture);
    if (p.air && snapshot.section) p.air->set_air(snapshot, picture.framed, camera, p.pool);
    if (p.plants) p.plants->choose(p.plant_ground(camera), camera);
    if (p.streamers)
        p.streamers->choose(*lit.blown, picture.pose.frame.value_or(snapshot.step),
                            p.plant_ground(camera), camera);
}

Image Renderer::draw(const ReadyPicture& picture) {
    Parts& p = *parts_;
    const Camera& camera = picture.pose.camera;
    const bool open = p.open();
    if (p.lens()) {
        Image image = p.lens_picture(camera, picture.lens_points);
        gl::check_errors("a picture through a lens");
        return image;
    }
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
