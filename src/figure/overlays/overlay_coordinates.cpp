#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"
#include "figure/panels/block_coordinates.h"
#include "figure/panels/ground_axes.h"
#include "figure/plot/coordinate_marks.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

class CoordinatesOverlay : public Overlay {
  public:
    explicit CoordinatesOverlay(const OverlayScene& on)
        : view_(on.scene.view),
          last_step_(on.scene.run.steps),
          shown_(on.shown),
          block_(framed_block(view_, on.shown)),
          scale_(on.first.scale),
          length_x_(on.first.bed.nx() * on.first.scale.dx),
          length_y_(on.first.bed.ny() * on.first.scale.dy) {}

    [[nodiscard]] bool fills_picture() const override { return true; }
    void avoid_boxes(const std::vector<CanvasBox>& taken, double plate) override {
        taken_ = taken;
        plate_ = plate;
    }
    [[nodiscard]] FurnitureSize size(const Canvas&) const override { return {}; }

    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const auto [block, camera] = camera_in(frame);
        const auto text = [](const glm::dvec3& v) {
            return fmt::format("{} {} {} ", v.x, v.y, v.z);
        };
        return text(camera.eye) + text(camera.right) + text(camera.up) +
               fmt::format("{} {} {}", camera.half.x, camera.half.y, block.base);
    }

    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const auto [block, camera] = camera_in(frame);
        const ViewProjection view{camera, block, box};
        if (is_map(camera)) {
            draw_around_map(canvas, view);
        } else {
            draw_under_block(canvas, view);
        }
    }

  private:
    static bool is_map(const Camera& camera) {
        return !camera.perspective && camera.forward.z < -1.0 + 1e-9 && camera.up.y > 1.0 - 1e-9;
    }

    [[nodiscard]] std::pair<Block, Camera> camera_in(const OverlayFrame& frame) const {
        const std::optional<Snapshot> reshaped = shown_snapshot(frame.snapshot, view_);
        const Snapshot& snapshot = reshaped ? *reshaped : frame.snapshot;
        const Block block = block_of_frame(block_, view_.look, shown_, snapshot);
        if (frame.camera != nullptr) return {block, *frame.camera};
        return {block, above_ground(camera_at_step(view_, block_, snapshot.step, last_step_), block,
                                    snapshot)};
    }

    [[nodiscard]] CoordinateAxis axis(bool along_x) const {
        return {CoordinateScale(
                    scale_, along_x ? CoordinateScale::Axis::east : CoordinateScale::Axis::north),
                along_x ? length_x_ : length_y_,
                {},
                {},
                false};
    }

    void draw_around_map(Canvas& canvas, const ViewProjection& view) const {
        const Block& block = view.block;
        const CanvasPoint low = view.at({-0.5 * block.width_x, -0.5 * block.width_y, block.base});
        const CanvasPoint high = view.at({0.5 * block.width_x, 0.5 * block.width_y, block.base});
        const CanvasBox frame{low.x, high.y, high.x - low.x, low.y - high.y};
        const CanvasBox shown = on_canvas(frame, canvas);
        canvas.stroke(std::array<CanvasPoint, 5>{{{shown.x, shown.y},
                                                  {shown.right(), shown.y},
                                                  {shown.right(), shown.bottom()},
                                                  {shown.x, shown.bottom()},
                                                  {shown.x, shown.y}}},
                      canvas.line_width(), coordinate_ink);
        CoordinateAxis east = axis(true);
        CoordinateAxis north = axis(false);
        const auto along = [](double from, double length, double share, double low_end,
                              double high_end) -> std::optional<double> {
            const double at = from + length * share;
            return at < low_end || at > high_end ? std::nullopt : std::optional(at);
        };
        east.seen = [=, this](double place) -> std::optional<CanvasPoint> {
            const auto x = along(frame.x, frame.width, place / length_x_, shown.x, shown.right());
            return x ? std::optional(CanvasPoint{*x, shown.bottom()}) : std::nullopt;
        };
        east.outward = [](double) { return CanvasPoint{0.0, 1.0}; };
        north.seen = [=, this](double place) -> std::optional<CanvasPoint> {
            const auto y =
                along(frame.bottom(), -frame.height, place / length_y_, shown.y, shown.bottom());
            return y ? std::optional(CanvasPoint{shown.x, *y}) : std::nullopt;
        };
        north.outward = [](double) { return CanvasPoint{-1.0, 0.0}; };
        north.upright = true;
        draw_marks(canvas, std::array{east, north});
    }

    /// The part of a box that lies on a canvas, its line too.
    static CanvasBox on_canvas(const CanvasBox& box, const Canvas& canvas) {
        const double edge = 0.5 * canvas.line_width();
        const double x = std::max(box.x, edge);
        const double y = std::max(box.y, edge);
        return {x, y, std::min(box.right(), canvas.width() - edge) - x,
                std::min(box.bottom(), canvas.height() - edge) - y};
    }

    void draw_under_block(Canvas& canvas, const ViewProjection& view) const {
        const BlockCoordinates shown = block_coordinates(view, scale_, length_x_, length_y_);
        for (const std::vector<CanvasPoint>& line : shown.lines)
            canvas.stroke(line, canvas.line_width(), coordinate_ink);
        draw_marks(canvas, shown.axes);
    }

    void draw_marks(Canvas& canvas, std::span<const CoordinateAxis> axes) const {
        draw_coordinate_marks(
            canvas,
            coordinate_marks(canvas, axes, taken_, {0.0, 0.0, canvas.width(), canvas.height()}),
            plate_);
    }

    View view_;
    std::int64_t last_step_;
    Snapshot shown_;
    Block block_;
    WorldScale scale_;
    double length_x_;
    double length_y_;
    double plate_ = 0.0;
    std::vector<CanvasBox> taken_;
};

}  // namespace

/// The coordinates of the terrain's file, along a map's frame or the two lower edges of a block
/// that the camera stands before: ticks at round numbers, with texts that neither overlap one
/// another and the plates of other overlays nor leave the picture. None over a section's flat
/// figure, whose axes have numbers, a profile, or endless ground.
std::unique_ptr<Overlay> make_coordinates_overlay(const OverlayScene& on, std::size_t number) {
    const bool profile = on.flat || on.first.section || on.first.bed.ny() < 2;
    const bool endless = !profile && is_endless(on.scene.view, on.first);
    if (profile || endless) {
        throw KeyError(
            overlay_key(number, "kind"),
            fmt::format("overlay.{} shows coordinates along a map or a block; {}", number,
                        endless ? "this ground is endless" : "this bed is a profile"));
    }
    return std::make_unique<CoordinatesOverlay>(on);
}

}  // namespace fumon
