#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

constexpr double map_rim_share = 0.16;       // of its longer side, for cameras that stand outside
constexpr double sight_length_share = 0.34;  // of its longer side
constexpr double least_level_sight_share =
    0.2;  // of a look's length: steeper ones have no direction
constexpr std::array<double, 3> sand{232.0, 215.0, 184.0};
constexpr Ink sight_ink{0.75, 0.16, 0.08, 0.30};
constexpr Ink camera_ink{0.75, 0.16, 0.08, 1.0};
constexpr Ink frame_ink{0.25, 0.22, 0.18, 1.0};

/// The bed around each pixel, north up, and whether any of it has data.
struct Plan {
    Grid heights;
    std::vector<std::uint8_t> opacity;
};

/// The cells around one pixel's middle and their weights, which fall evenly to 0 over as many whole
/// cells as a pixel is broad: with whole ones an even slope stays even.
struct CellsAround {
    int first = 0;
    std::vector<double> weights;
};

CellsAround cells_around(int pixel, int pixels, int cells) {
    const double breadth = static_cast<double>(cells) / pixels;
    const double reach = std::ceil(breadth);
    const double middle = (pixel + 0.5) * breadth - 0.5;
    CellsAround around;
    around.first = std::max(0, static_cast<int>(std::ceil(middle - reach)));
    const int last = std::min(cells - 1, static_cast<int>(std::floor(middle + reach)));
    for (int cell = around.first; cell <= last; ++cell)
        around.weights.push_back(std::max(1.0 - std::abs(cell - middle) / reach, 0.0));
    return around;
}

Plan plan_of(const Snapshot& bed, int width, int height) {
    Plan plan{Grid(width, height), {}};
    std::vector<CellsAround> columns;
    columns.reserve(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) columns.push_back(cells_around(x, width, bed.bed.nx()));
    for (int y = 0; y < height; ++y) {
        const CellsAround rows = cells_around(height - 1 - y, height, bed.bed.ny());
        for (int x = 0; x < width; ++x) {
            const CellsAround& across = columns[static_cast<std::size_t>(x)];
            double sum = 0.0;
            double weights = 0.0;
            for (std::size_t j = 0; j < rows.weights.size(); ++j) {
                for (std::size_t i = 0; i < across.weights.size(); ++i) {
                    const int column = across.first + static_cast<int>(i);
                    const int row = rows.first + static_cast<int>(j);
                    if (!bed.nodata.empty() && bed.nodata(column, row) != 0) continue;
                    const double weight = rows.weights[j] * across.weights[i];
                    sum += weight * bed.bed(column, row);
                    weights += weight;
                }
            }
            plan.heights(x, y) = weights > 0.0 ? sum / weights : 0.0;
            plan.opacity.push_back(weights > 0.0 ? 255 : 0);
        }
    }
    return plan;
}

/// The bed from above, lit from the north-west. `rise`: z of one height over the breadth of a
/// pixel.
Image lit(const Plan& plan, double rise) {
    const Grid& heights = plan.heights;
    Image image(heights.nx(), heights.ny());
    for (int y = 0; y < heights.ny(); ++y) {
        const int above = std::max(y - 1, 0);
        const int below = std::min(y + 1, heights.ny() - 1);
        std::uint8_t* out = image.row(y);
        for (int x = 0; x < heights.nx(); ++x) {
            const int left = std::max(x - 1, 0);
            const int right = std::min(x + 1, heights.nx() - 1);
            const double east = 0.5 * rise * (heights(right, y) - heights(left, y));
            const double north = 0.5 * rise * (heights(x, above) - heights(x, below));
            const double facing =
                (1.0 + 0.9 * (east - north)) / std::sqrt(1.0 + east * east + north * north);
            const double light = std::clamp(0.35 + 0.62 * facing, 0.25, 1.1);
            for (const double colour : sand)
                *out++ = static_cast<std::uint8_t>(std::min(255.0, light * colour + 0.5));
        }
    }
    return image;
}

class InsetMapOverlay : public Overlay {
  public:
    InsetMapOverlay(const OverlayScene& on, const OverlaySettings& settings)
        : view_(with_chosen_ground(on.scene.view, on.shown)),
          last_step_(on.scene.run.steps),
          block_(framed_block(view_, on.shown)),
          goes_on_(view_.look.ground == Ground::endless && on.shown.periodic),
          length_(settings.size *
                  static_cast<double>(std::min(view_.image.width, view_.image.height))) {}

    [[nodiscard]] FurnitureSize size(const Canvas& /*canvas*/) const override {
        return {length_ * block_.width_x + 2.0 * rim(), length_ * block_.width_y + 2.0 * rim()};
    }

    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const Camera camera = camera_of_frame(frame);
        return fmt::format("{} {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}", frame.snapshot.step,
                           camera.eye.x, camera.eye.y, camera.forward.x, camera.forward.y,
                           camera.half.x);
    }

    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const CanvasBox map{box.x + rim(), box.y + rim(), length_ * block_.width_x,
                            length_ * block_.width_y};
        const std::optional<Snapshot> reshaped = shown_snapshot(frame.snapshot, view_);
        const int width = std::max(1, static_cast<int>(std::lround(map.width)));
        const int height = std::max(1, static_cast<int>(std::lround(map.height)));
        const Plan plan = plan_of(reshaped ? *reshaped : frame.snapshot, width, height);
        canvas.draw(lit(plan, block_.height_scale * length_), map, plan.opacity);
        const double line = std::max(1.0, 0.004 * length_);
        const std::array<CanvasPoint, 5> outline{{{map.x, map.y},
                                                  {map.right(), map.y},
                                                  {map.right(), map.bottom()},
                                                  {map.x, map.bottom()},
                                                  {map.x, map.y}}};
        canvas.stroke(outline, line, frame_ink);
        draw_camera(canvas, box, map, camera_of_frame(frame));
    }

  private:
    [[nodiscard]] double rim() const { return goes_on_ ? 0.0 : map_rim_share * length_; }

    [[nodiscard]] Camera camera_of_frame(const OverlayFrame& frame) const {
        if (frame.camera != nullptr) return *frame.camera;
        return camera_at_step(view_, block_, frame.snapshot.step, last_step_);
    }

    /// A dot where it stands, or on the rim nearest to there, and a wedge over what it sees.
    void draw_camera(Canvas& canvas, const CanvasBox& box, const CanvasBox& map,
                     const Camera& camera) const {
        const double dot = std::max(2.0, 0.022 * length_);
        glm::dvec2 eye(camera.eye);
        if (goes_on_) {
            eye.x -= block_.width_x * std::floor(eye.x / block_.width_x + 0.5);
            eye.y -= block_.width_y * std::floor(eye.y / block_.width_y + 0.5);
        }
        const CanvasPoint at{std::clamp(map.x + length_ * (eye.x + 0.5 * block_.width_x),
                                        box.x + dot, box.right() - dot),
                             std::clamp(map.y + length_ * (0.5 * block_.width_y - eye.y),
                                        box.y + dot, box.bottom() - dot)};
        const glm::dvec2 ahead(camera.forward);
        if (glm::length(ahead) > least_level_sight_share) {
            constexpr int rays = 12;
            const double half = camera.perspective ? std::min(camera.half.x, 3.0) : 0.15;
            std::vector<CanvasPoint> wedge{at};
            for (int i = -rays; i <= rays; ++i) {
                const glm::dvec2 way =
                    glm::normalize(glm::normalize(ahead) +
                                   half * static_cast<double>(i) / rays * glm::dvec2(camera.right));
                const double reach = sight_length_share * length_;
                wedge.push_back({std::clamp(at.x + reach * way.x, box.x, box.right()),
                                 std::clamp(at.y - reach * way.y, box.y, box.bottom())});
            }
            canvas.fill(wedge, sight_ink);
            wedge.push_back(at);
            canvas.stroke(wedge, std::max(1.0, 0.006 * length_), camera_ink);
        }
        canvas.fill_circle(at, dot, camera_ink);
    }

    View view_;
    std::int64_t last_step_;
    Block block_;
    bool goes_on_;
    double length_;  ///< pixels of the bed's longer side
};

}  // namespace

/// The bed of the frame from above, north up, with where the camera stands (on the rim, where that
/// is outside) and what it sees from there. overlay.size of the picture's shorter side is the bed's
/// longer one. None over sections, profiles and maps.
std::unique_ptr<Overlay> make_inset_map_overlay(const OverlayScene& on, std::size_t number) {
    const bool from_above = on.scene.view.camera.projection == Projection::map && !on.camera_moves;
    if (on.flat || on.first.section || on.first.bed.ny() < 2 || from_above) {
        throw KeyError(overlay_key(number, "kind"),
                       fmt::format("overlay.{} is a map of the camera's position; {}", number,
                                   from_above ? "this picture is already a map"
                                              : "this bed is a profile, which has no map"));
    }
    return std::make_unique<InsetMapOverlay>(on, on.scene.view.overlays[number]);
}

}  // namespace fumon
