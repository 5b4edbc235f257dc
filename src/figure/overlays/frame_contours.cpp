#include "figure/overlays/frame_contours.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "figure/canvas/layers.h"
#include "figure/panels/contours.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

/// The ground of a frame, as far as it hides what lies behind it.
class HidingGround {
  public:
    HidingGround(const Snapshot& snapshot, const Block& block, const Camera& camera)
        : snapshot_(snapshot),
          block_(block),
          camera_(camera),
          cells_(snapshot.bed.nx() / block.width_x, snapshot.bed.ny() / block.width_y) {
        highest_ = block.z(*std::ranges::max_element(snapshot.bed.values()));
    }

    /// Of a place in cells, the middle of the first being (0, 0).
    [[nodiscard]] glm::dvec3 point(const glm::dvec2& cell) const {
        return {(cell.x + 0.5) / cells_.x - 0.5 * block_.width_x,
                (cell.y + 0.5) / cells_.y - 0.5 * block_.width_y, z(cell)};
    }

    /// Whether the camera sees a point of the ground: whether nothing on the way, half a cell at a
    /// time, rises above it.
    [[nodiscard]] bool seen(const glm::dvec2& cell) const {
        const glm::dvec3 from = point(cell);
        if (camera_.perspective &&
            glm::dot(from - camera_.eye, camera_.forward) < camera_.near_depth)
            return false;
        const glm::dvec3 towards = camera_.perspective ? camera_.eye - from : -camera_.forward;
        const glm::dvec3 in_cells(towards.x * cells_.x, towards.y * cells_.y, towards.z);
        const double level = glm::length(glm::dvec2(in_cells));
        if (level < 1e-9) return true;
        const glm::dvec3 step = in_cells * (0.5 / level);
        const double most = camera_.perspective ? 2.0 * level : 1e9;
        const double slack = 0.03 / std::max(cells_.x, cells_.y);
        for (double k = 2.0; k < most; k += 1.0) {
            const glm::dvec2 here = cell + k * glm::dvec2(step);
            const double height = from.z + k * step.z;
            if (height > highest_ || !inside(here)) return true;
            if (z(here) > height + slack) return false;
        }
        return true;
    }

  private:
    [[nodiscard]] bool inside(const glm::dvec2& cell) const {
        return cell.x >= -0.5 && cell.y >= -0.5 && cell.x <= snapshot_.bed.nx() - 0.5 &&
               cell.y <= snapshot_.bed.ny() - 0.5;
    }
    /// Of the bed, linear between cells.
    [[nodiscard]] double z(const glm::dvec2& cell) const {
        const Grid& bed = snapshot_.bed;
        const auto split = [](double place, int count) {
            const double within = std::clamp(place, 0.0, count - 1.0);
            const int low = std::min(static_cast<int>(within), std::max(count - 2, 0));
            return std::pair(low, within - low);
        };
        const auto [x, s] = split(cell.x, bed.nx());
        const auto [y, t] = split(cell.y, bed.ny());
        const int east = std::min(x + 1, bed.nx() - 1);
        const int north = std::min(y + 1, bed.ny() - 1);
        return block_.z(std::lerp(std::lerp(bed(x, y), bed(east, y), s),
                                  std::lerp(bed(x, north), bed(east, north), s), t));
    }

    const Snapshot& snapshot_;
    const Block& block_;
    const Camera& camera_;
    glm::dvec2 cells_;  ///< in a block length
    double highest_ = 0.0;
};

}  // namespace

FrameContours::FrameContours(const OverlayScene& on, double font_size)
    : scene_(on.scene),
      first_(on.shown),
      block_(framed_block(on.scene.view, on.shown)),
      font_size_(font_size) {}

void FrameContours::draw(Image& image, const OverlayFrame& frame,
                         const std::vector<CanvasBox>& taken, double opacity) const {
    const std::optional<Snapshot> reshaped = shown_snapshot(frame.snapshot, scene_.view);
    const Snapshot& snapshot = reshaped ? *reshaped : frame.snapshot;
    const auto contours = ground_contours(scene_.view.look.contours, snapshot);
    if (!contours) return;
    const Block block = block_of_frame(block_, scene_.view.look, first_, snapshot);
    const Camera camera =
        frame.camera != nullptr
            ? *frame.camera
            : above_ground(camera_at_step(scene_.view, block_, snapshot.step, scene_.run.steps),
                           block, snapshot);
    const HidingGround ground(snapshot, block, camera);
    const auto pixel = [&](const glm::dvec2& cell) -> CanvasPoint {
        const glm::dvec2 place = project(camera, ground.point(cell));
        return {(0.5 + 0.5 * place.x) * image.width, (0.5 - 0.5 * place.y) * image.height};
    };
    std::vector<CanvasContour> lines;
    for (const ContourLine& line : contours->lines) {
        CanvasContour part{line.level, {}};
        for (const glm::dvec2& point : line.points) {
            if (ground.seen(point)) {
                part.points.push_back(pixel(point));
            } else if (!part.points.empty()) {
                lines.push_back(std::exchange(part, {line.level, {}}));
            }
        }
        if (!part.points.empty()) lines.push_back(std::move(part));
    }
    Canvas canvas(image.width, image.height, font_size_, CanvasGround::transparent);
    draw_contours(canvas,
                  {0.0, 0.0, static_cast<double>(image.width), static_cast<double>(image.height)},
                  lines, contours->interval, taken);
    lay_over(image, canvas.layer(), 0, 0, opacity);
}

}  // namespace fumon
