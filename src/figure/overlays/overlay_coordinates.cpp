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
#include "figure/overlays/coordinate_marks.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"
#include "figure/panels/ground_axes.h"
#include "render/view/chosen_ground.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

constexpr Ink line_ink{0.1, 0.1, 0.1, 0.85};
constexpr double plate_room = 0.18;  // around a text, font sizes

/// A lower edge of the block: along x or y, at one of the two sides across.
struct Edge {
    bool along_x = true;
    bool at_low = true;  ///< the southern or western one

    /// A point of it, `share` along and `beyond` the block, in the block's lengths.
    [[nodiscard]] glm::dvec3 point(const Block& block, double share, double beyond = 0.0) const {
        const double side = (at_low ? -1.0 : 1.0) * (along_x ? block.width_y : block.width_x);
        const double across = 0.5 * side + (at_low ? -beyond : beyond);
        const double along = (share - 0.5) * (along_x ? block.width_x : block.width_y);
        return along_x ? glm::dvec3(along, across, block.base)
                       : glm::dvec3(across, along, block.base);
    }
    /// How far the camera stands before the block's wall over it; of an orthographic one, how much
    /// the wall faces it.
    [[nodiscard]] double before(const Block& block, const Camera& camera) const {
        const glm::dvec3 out = point(block, 0.5, 1.0) - point(block, 0.5);
        if (!camera.perspective) return -glm::dot(out, camera.forward);
        return glm::dot(out, camera.eye - point(block, 0.5));
    }
};

/// Of the two edges along x, or along y, the one before which the camera stands.
Edge nearer_edge(const Block& block, const Camera& camera, bool along_x) {
    const Edge low{along_x, true};
    const Edge high{along_x, false};
    return low.before(block, camera) >= high.before(block, camera) ? low : high;
}

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
    void stand_among(const std::vector<CanvasBox>& taken, double plate) override {
        taken_ = taken;
        plate_ = plate;
    }
    [[nodiscard]] FurnitureSize size(const Canvas&) const override { return {}; }

    [[nodiscard]] std::string look_in(const OverlayFrame& frame) const override {
        const auto [block, camera] = seen_in(frame);
        const auto text = [](const glm::dvec3& v) {
            return fmt::format("{} {} {} ", v.x, v.y, v.z);
        };
        return text(camera.eye) + text(camera.right) + text(camera.up) +
               fmt::format("{} {} {}", camera.half.x, camera.half.y, block.base);
    }

    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const auto [block, camera] = seen_in(frame);
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

    [[nodiscard]] std::pair<Block, Camera> seen_in(const OverlayFrame& frame) const {
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
                      canvas.line_width(), line_ink);
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
        std::vector<CoordinateAxis> axes;
        for (const bool along_x : {true, false}) {
            const Edge edge = nearer_edge(view.block, view.camera, along_x);
            draw_edge(canvas, view, edge);
            CoordinateAxis one = axis(along_x);
            const double length = one.length;
            one.seen = [=](double place) {
                return seen(view, edge.point(view.block, place / length));
            };
            one.outward = [=](double place) { return outward(view, edge, place / length); };
            axes.push_back(std::move(one));
        }
        draw_marks(canvas, axes);
    }

    static std::optional<CanvasPoint> seen(const ViewProjection& view, const glm::dvec3& point) {
        const Camera& camera = view.camera;
        if (camera.perspective && glm::dot(point - camera.eye, camera.forward) < camera.near_depth)
            return std::nullopt;
        return view.at(point);
    }

    /// Away from the block on the ground, as it is seen; downward where that is no direction.
    static CanvasPoint outward(const ViewProjection& view, const Edge& edge, double share) {
        constexpr double step = 1e-3;
        const CanvasPoint at = view.at(edge.point(view.block, share));
        const CanvasPoint beyond = view.at(edge.point(view.block, share, step));
        const glm::dvec2 way(beyond.x - at.x, beyond.y - at.y);
        const double length = glm::length(way);
        if (!(length > 1e-6)) return {0.0, 1.0};
        return {way.x / length, way.y / length};
    }

    static void draw_edge(Canvas& canvas, const ViewProjection& view, const Edge& edge) {
        constexpr int parts = 32;
        std::vector<CanvasPoint> line;
        for (int i = 0; i <= parts; ++i) {
            const auto point = seen(view, edge.point(view.block, static_cast<double>(i) / parts));
            if (point) line.push_back(*point);
        }
        if (line.size() > 1) canvas.stroke(line, canvas.line_width(), line_ink);
    }

    void draw_marks(Canvas& canvas, std::span<const CoordinateAxis> axes) const {
        for (const CoordinateMark& mark : coordinate_marks(canvas, axes, taken_)) {
            const CanvasBox plate = grown(mark.box, plate_room * canvas.font_size());
            if (plate_ > 0.0) canvas.fill(plate, {1.0, 1.0, 1.0, plate_});
            canvas.stroke(std::array{mark.from, mark.to}, canvas.line_width(), line_ink);
            canvas.write(mark.text, mark.box.middle(), {0.5, 0.5}, black_ink, 1.0, mark.upright);
        }
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
    const bool endless = !profile && goes_on_endlessly(on.scene.view, on.first);
    if (profile || endless) {
        throw KeyError(
            overlay_key(number, "kind"),
            fmt::format("overlay.{} has the coordinates along a map or a block; {}", number,
                        endless ? "this ground is endless" : "this bed is a profile"));
    }
    return std::make_unique<CoordinatesOverlay>(on);
}

}  // namespace fumon
