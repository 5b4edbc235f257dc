#include "run/frame_painter.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/panels/section_figure.h"
#include "files/hash.h"
#include "gl/pinned.h"
#include "picture/fingerprint.h"
#include "render/renderer.h"
#include "render/view/ground_choice.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

bool draws_layers(PaintedContent frames) {
    return frames == PaintedContent::layers || frames == PaintedContent::pictures_and_layers;
}

class BedPainter : public FramePainter {
  public:
    BedPainter(const Scene& scene, const Snapshot& first, gl::Backend backend, WorkerPool& pool,
               PaintedContent frames)
        : context_(gl::Context::create(backend)),
          places_(scene.output.exr_layers == ExrLayers::all) {
        RenderLimits limits;
        limits.one_picture =
            frames == PaintedContent::one_picture || frames == PaintedContent::layers;
        const auto make = [&](PixelFormat kind) {
            return std::make_unique<Renderer>(*context_, scene.view, first, scene.run.steps, pool,
                                              limits, kind);
        };
        if (frames != PaintedContent::layers)
            pictures_ = make(scene.view.image.deep_colour ? PixelFormat::display_16
                                                          : PixelFormat::display_8);
        if (draws_layers(frames)) layers_ = make(PixelFormat::radiance);
    }

    ~BedPainter() override { context_->make_current(); }  // others may have drawn since
    BedPainter(const BedPainter&) = delete;
    BedPainter& operator=(const BedPainter&) = delete;

    Image paint(const Snapshot& snapshot, const MeasuredRows& /*rows*/) override {
        return pictures_->render(snapshot);
    }
    LayeredImage paint_layers(const Snapshot& snapshot) override {
        return layers_->render_layers(snapshot, places_);
    }
    void keep_colours() override {
        if (pictures_) pictures_->keep_colours();
        if (layers_) layers_->keep_colours();
    }
    [[nodiscard]] std::optional<Camera> camera_on_land() const override {
        return any().camera_on_land();
    }
    [[nodiscard]] FrameColourRange frame_colour_range() const override {
        return any().frame_colour_range();
    }
    [[nodiscard]] DrawingRecord record() const override {
        const std::string name = context_->renderer_name();
        const std::string obstacle = gl::rendering_is_pinned() ? gl::pinning_obstacle(name) : "";
        return {opengl_environment(context_->backend_name(), name, context_->version(),
                                   gl::rendering_is_pinned() && obstacle.empty()),
                obstacle, any().exaggeration(), ""};
    }

  private:
    [[nodiscard]] const Renderer& any() const { return pictures_ ? *pictures_ : *layers_; }

    std::unique_ptr<gl::Context> context_;
    bool places_;
    std::unique_ptr<Renderer> pictures_;
    std::unique_ptr<Renderer> layers_;
};

class SectionPainter : public FramePainter {
  public:
    SectionPainter(const Scene& scene, const Snapshot& first)
        : view_(scene.view), exaggeration_(draw_section_figure(view_, first).exaggeration) {}

    Image paint(const Snapshot& snapshot, const MeasuredRows& /*rows*/) override {
        return draw_section_figure(view_, snapshot).image;
    }
    LayeredImage paint_layers(const Snapshot& /*snapshot*/) override {
        throw std::logic_error("a flat figure has no layers");
    }
    [[nodiscard]] DrawingRecord record() const override {
        RenderingEnvironment environment;
        environment.backend = "cairo";
        environment.renderer = figure_library();
        return {environment, gl::rendering_is_pinned() ? text_is_not_pinned : "", exaggeration_,
                figure_library()};
    }

  private:
    View view_;
    double exaggeration_;
};

/// Lays a scene's overlays over what another painter draws.
class OverlayPainter : public FramePainter {
  public:
    /// The scene outlives it. Throws what FrameOverlays throws.
    OverlayPainter(std::unique_ptr<FramePainter> under, const Scene& scene, const Snapshot& first,
                   bool one_picture)
        : under_(std::move(under)), overlays_(scene, first), one_picture_(one_picture) {}

    Image paint(const Snapshot& snapshot, const MeasuredRows& rows) override {
        Image image = under_->paint(snapshot, rows);
        if (one_picture_) pixels_under_ = hex(pixel_hash(image));
        const std::vector<std::uint8_t> before =
            image.rgb16.empty() ? std::vector<std::uint8_t>{} : image.rgb;
        const std::optional<Camera> camera = under_->camera_on_land();
        overlays_.draw(image,
                       {snapshot, rows, under_->frame_colour_range(), camera ? &*camera : nullptr});
        // Overlays are of 8 bits.
        for (std::size_t i = 0; i < image.rgb16.size(); ++i) {
            if (image.rgb[i] != before[i])
                image.rgb16[i] = static_cast<std::uint16_t>(257U * image.rgb[i]);
        }
        return image;
    }
    LayeredImage paint_layers(const Snapshot& snapshot) override {
        return under_->paint_layers(snapshot);
    }
    void keep_colours() override { under_->keep_colours(); }
    [[nodiscard]] FrameColourRange frame_colour_range() const override {
        return under_->frame_colour_range();
    }
    [[nodiscard]] DrawingRecord record() const override {
        DrawingRecord record = under_->record();
        record.text_library = figure_library();
        record.under_overlays = pixels_under_;
        if (overlays_.uses_system_fonts()) {
            record.environment.pinned = false;
            if (gl::rendering_is_pinned()) record.pinning_obstacle = text_is_not_pinned;
        }
        return record;
    }

  private:
    std::unique_ptr<FramePainter> under_;
    FrameOverlays overlays_;
    bool one_picture_;
    std::string pixels_under_;
};

std::unique_ptr<FramePainter> make_bare_painter(const Scene& scene, const Snapshot& first,
                                                gl::Backend backend, WorkerPool& pool,
                                                PaintedContent frames) {
    check_background(scene.view, first);
    if (draws_layers(frames)) check_layers(scene, first);
    if (first.section && scene.view.look.mode == ViewMode::figure)
        return std::make_unique<SectionPainter>(scene, first);
    return std::make_unique<BedPainter>(scene, first, backend, pool, frames);
}

}  // namespace

void check_layers(const Scene& scene, const Snapshot& first) {
    const View& view = scene.view;
    if (first.section && view.look.mode == ViewMode::figure) {
        throw KeyError("look.mode",
                       "the flat figure of a section cannot be written as OpenEXR; write look.mode "
                       "= \"scenic\", or PNG");
    }
    constexpr double gibibyte = 1 << 30;
    constexpr double most = 16.0;   // GiB
    constexpr double copies = 2.0;  // of the layers: what draws them, and the file
    const double colours =
        copies * 4.0 * 4.0 * static_cast<double>(view.image.width * view.image.height);
    const bool all = scene.output.exr_layers == ExrLayers::all;
    const double others = all ? 8.0 + static_cast<double>(first.fields.size()) : 0.0;
    const double taken = colours * (1.0 + 0.25 * others) / gibibyte;
    if (taken <= most) return;
    throw KeyError(
        "image.width",
        fmt::format(
            "{} x {} pixels as OpenEXR take {:.1f} GiB of memory, more than {:g}; {}",
            view.image.width, view.image.height, taken, most,
            all && colours <= most * gibibyte
                ? fmt::format("output.exr_layers = \"colour\" takes {:.1f}", colours / gibibyte)
                : "make it smaller"));
}

std::unique_ptr<FramePainter> make_frame_painter(const Scene& scene, const Snapshot& first,
                                                 gl::Backend backend, WorkerPool& pool,
                                                 PaintedContent frames) {
    auto bare = make_bare_painter(scene, first, backend, pool, frames);
    if (!has_overlays(scene) || frames == PaintedContent::layers) return bare;
    return std::make_unique<OverlayPainter>(std::move(bare), scene, first,
                                            frames == PaintedContent::one_picture);
}

}  // namespace fumon
