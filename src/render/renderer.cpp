#include "render/renderer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/cancellation.h"
#include "gl/functions.h"
#include "render/frame/view_uniforms.h"
#include "render/frame_passes.h"
#include "render/picture_drawing.h"
#include "render/ready_picture.h"
#include "render/renderer_state.h"
#include "render/samples/accumulated_light.h"
#include "render/samples/float_picture.h"
#include "render/tile_drawing.h"
#include "scene/placed_sun.h"

namespace fumon {

namespace {

void draw_tile(RendererState& state, const Tile& tile, const Camera& camera,
               TileDrawing::Output output) {
    gl::functions().BindVertexArray(state.no_attributes.name());
    TileDrawing drawing(state, tile, camera, output);
    run(drawing.by_block_passes() ? block_passes() : sample_passes(), drawing);
}

Image blank_image(const RendererState& state) {
    Image image(static_cast<int>(state.view.image.width),
                static_cast<int>(state.view.image.height));
    if (state.open()) image = with_alpha(std::move(image));
    return image;
}

}  // namespace

Renderer::Renderer(gl::Context& context, const View& view, const Snapshot& first,
                   std::int64_t last_step, WorkerPool& pool, const RenderLimits& limits,
                   PixelFormat kind) {
    context.make_current();
    state_ = std::make_unique<RendererState>(context, view, first, last_step, pool, limits, kind);
}

Renderer::~Renderer() = default;

double Renderer::exaggeration() const {
    return state_->block.exaggeration;
}

void Renderer::keep_colours() {
    state_->shading.keep_range();
}

const FrameColourRange& Renderer::frame_colour_range() const {
    return state_->shading.range();
}

ReadyPicture Renderer::ready(std::shared_ptr<const Snapshot> snapshot, const FramePose& pose,
                             const std::shared_ptr<const LitBed>& before, WorkerPool& pool) const {
    SunSettings sun = pose.sun;
    sun.diameter = state_->view.sun.diameter;
    ReadyPicture picture =
        state_->ready(std::move(snapshot), sun_direction(sun), pose, before, pool);
    picture.sun_share = state_->sun_share(picture);
    return picture;
}

ReadyPicture Renderer::ready_at_step(const Snapshot& snapshot) const {
    const std::shared_ptr<const Snapshot> lent(std::shared_ptr<const Snapshot>(), &snapshot);
    const double share = share_of_run(snapshot.step, state_->last_step);
    const SunSettings sun = sun_at(state_->view.sun, share);
    ReadyPicture picture =
        state_->ready(lent, sun_direction(sun), std::nullopt, nullptr, state_->pool);
    picture.pose.sun = sun;
    picture.pose.share = share;
    picture.sun_share = state_->sun_share(picture);
    return picture;
}

Image Renderer::render(const Snapshot& snapshot) {
    const ReadyPicture picture = ready_at_step(snapshot);
    prepare_sky(picture);
    prepare(picture);
    state_->uploaded.reset();  // no later picture is of this snapshot
    if (state_->plain) on_land_ = picture.pose.camera;
    return draw(picture);
}

Image Renderer::render(const ReadyPicture& picture) {
    prepare_pose(picture);
    return draw(picture);
}

void Renderer::prepare_pose(const ReadyPicture& picture) {
    state_->context.make_current();
    state_->set_light(picture.pose);
    state_->background.expect_other_cameras();
    prepare(picture);
}

LayeredImage Renderer::radiances(const ReadyPicture& picture) {
    LayeredImage image;
    image.width = static_cast<int>(state_->view.image.width);
    image.height = static_cast<int>(state_->view.image.height);
    set_matrices(image, picture.framed, picture.pose.camera);
    image.layers = draw_radiances(picture);
    return image;
}

LayeredImage Renderer::render_light(const ReadyPicture& picture) {
    prepare_pose(picture);
    LayeredImage image = radiances(picture);
    gl::check_errors("a frame's light");
    return image;
}

LayeredImage Renderer::render_layers(const Snapshot& whole, bool positions) {
    const ReadyPicture picture = ready_at_step(whole);
    prepare_sky(picture);
    prepare(picture);
    state_->uploaded.reset();
    LayeredImage image = radiances(picture);
    if (positions) {
        for (ImageLayer& layer : draw_positions(picture)) image.layers.push_back(std::move(layer));
    }
    gl::check_errors("a picture's layers");
    return image;
}

void Renderer::prepare_sky(const ReadyPicture& picture) {
    const View& view = state_->view;
    if (view.sun.hours == 0.0 && view.air.cloud_drift == 0.0) return;
    state_->context.make_current();
    state_->set_light(picture.pose);
}

void Renderer::prepare(const ReadyPicture& picture) {
    state_->context.make_current();
    PictureDrawing drawing(*state_, picture);
    run(picture_passes(), drawing);
}

Image Renderer::draw(const ReadyPicture& picture) {
    const Camera& camera = picture.pose.camera;
    Image image;
    if (state_->lens()) {
        image = draw_through_lens(picture);
    } else if (state_->kind == PixelFormat::display_16) {
        image = draw_deep(camera).display();
    } else {
        image = blank_image(*state_);
        for (const Tile& tile : state_->plan.tiles) draw_tile(*state_, tile, camera, &image);
        if (state_->open()) dilate_colours(image);
    }
    gl::check_errors("a frame");
    return image;
}

FloatPicture Renderer::draw_deep(const Camera& camera) {
    FloatPicture picture(static_cast<int>(state_->view.image.width),
                         static_cast<int>(state_->view.image.height), state_->kind, state_->open());
    for (const Tile& tile : state_->plan.tiles) draw_tile(*state_, tile, camera, &picture);
    return picture;
}

AccumulatedLight Renderer::gather_light(const Tile& tile, const ReadyPicture& picture) {
    AccumulatedLight accumulated(tile);
    const glm::dvec2 pixel(2.0 / static_cast<double>(state_->view.image.width),
                           2.0 / static_cast<double>(state_->view.image.height));
    Camera through = picture.pose.camera;
    for (const LensPoint& point : lens_points(picture.lens_points)) {
        if (state_->one_picture) throw_if_cancelled();
        through.lens.point = picture.pose.camera.lens.radius * point.on_disc;
        through.lens.aside = pixel * point.in_pixel;
        draw_tile(*state_, tile, through, &accumulated);
    }
    accumulated.finish(state_->pool);
    return accumulated;
}

Image Renderer::draw_through_lens(const ReadyPicture& picture) {
    RendererState& s = *state_;
    Image image = blank_image(s);
    const bool deep = s.wanted == PixelFormat::display_16;
    if (deep) image.rgb16.resize(image.rgb.size());
    if (!s.lens_tone)
        s.lens_tone.emplace(s.plan.tiles.front(),
                            fixed_uniforms(s.view, s.light, s.ground, s.wanted), deep);
    for (const Tile& tile : s.plan.tiles) {
        const AccumulatedLight accumulated = gather_light(tile, picture);
        gl::functions().BindVertexArray(s.no_attributes.name());
        s.lens_tone->put(accumulated, s.view, s.light, picture.pose.camera, s.block, image);
    }
    if (s.open()) dilate_colours(image);
    return image;
}

std::vector<ImageLayer> Renderer::draw_radiances(const ReadyPicture& picture) {
    if (!state_->lens()) return draw_deep(picture.pose.camera).take_channels();
    FloatPicture accumulated(static_cast<int>(state_->view.image.width),
                             static_cast<int>(state_->view.image.height), state_->kind,
                             state_->open());
    for (const Tile& tile : state_->plan.tiles) accumulated.put(gather_light(tile, picture));
    return accumulated.take_channels();
}

std::vector<ImageLayer> Renderer::draw_positions(const ReadyPicture& picture) {
    RendererState& s = *state_;
    const Camera& camera = picture.pose.camera;
    const bool plain = !s.world && !s.open() && s.view.look.mode == ViewMode::scenic;
    SurfacePositionLayers layers(
        static_cast<int>(s.view.image.width), static_cast<int>(s.view.image.height),
        {picture.shown(), picture.framed,
         s.plain ? s.plain->ground_of(picture.framed) : picture.framed, camera,
         s.drawn_surface(picture), s.copies, s.world.has_value(), plain});
    if (!s.positions) s.positions.emplace(s.plan.tiles.front());
    const SurfacePositionPass::Scene scene{
        s.world ? &*s.world : nullptr, s.terrain, s.plants ? &*s.plants : nullptr,
        s.persons ? &*s.persons : nullptr, s.ground_transform(camera)};
    for (const Tile& tile : s.plan.tiles)
        s.positions->draw({s.view, s.plan, tile, camera, s.light, s.pool}, scene, layers);
    return layers.take();
}

}  // namespace fumon
