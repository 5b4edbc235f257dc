#include "film/camera/kept_clear.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "render/view/camera.h"

namespace fumon {

namespace {

/// Whether points and a box lie on both sides of a line along which `across` is the same.
bool are_parted(const std::vector<glm::dvec2>& points, const PictureBox& box,
                const glm::dvec2& across) {
    const auto [least, most] = std::ranges::minmax(
        points, {}, [&](const glm::dvec2& point) { return glm::dot(point, across); });
    const glm::dvec2 middle = 0.5 * (box.low + box.high);
    const double reach = glm::dot(glm::abs(across), 0.5 * (box.high - box.low));
    const double at = glm::dot(middle, across);
    return glm::dot(least, across) > at + reach || glm::dot(most, across) < at - reach;
}

/// Those boxes of which something is in the picture.
std::vector<PictureBox> boxes_in_view(std::vector<PictureBox> boxes) {
    std::erase_if(boxes, [](const PictureBox& box) {
        return std::min(box.high.x, box.high.y) <= -1.0 || std::max(box.low.x, box.low.y) >= 1.0;
    });
    return boxes;
}

/// How poses are changed.
struct ClearPlace {
    double farther = 1.0;    ///< the distance to what is looked at, times this
    glm::dvec2 beside{0.0};  ///< where that is seen, −1 … 1
};

constexpr double most_farther = 2.0;
constexpr double most_farther_for_captions = 1.6;
constexpr double farther_step = 0.05;
constexpr int steps_beside = 10;  // to either side
constexpr double beside_step = 0.06;

/// Places beside the middle of a picture, the nearest first.
std::vector<glm::dvec2> places_beside() {
    std::vector<glm::dvec2> places;
    for (int j = -steps_beside; j <= steps_beside; ++j)
        for (int i = -steps_beside; i <= steps_beside; ++i)
            places.push_back(beside_step * glm::dvec2(i, j));
    std::ranges::stable_sort(places, {},
                             [](const glm::dvec2& place) { return glm::dot(place, place); });
    return places;
}

/// The block's corners before the cameras of some poses.
class PosesInView {
  public:
    PosesInView(const FilmStage& stage, const std::vector<CameraPose>& poses) {
        const double room = 1.0 - 2.0 * stage.scene.view.camera.margin;
        for (const CameraPose& pose : poses) {
            One one{camera_of(stage, pose), glm::length(pose.eye - pose.look_at), {}, {}};
            for (const glm::dvec3& corner : block_corners(stage.block)) {
                const glm::dvec3 from = corner - one.camera.eye;
                one.corners.emplace_back(glm::dot(from, one.camera.right),
                                         glm::dot(from, one.camera.up),
                                         glm::dot(from, one.camera.forward));
            }
            one.reach = glm::dvec2(room);
            for (const glm::dvec2& seen : one.seen({}))
                one.reach = glm::max(one.reach, glm::abs(seen));
            poses_.push_back(std::move(one));
        }
    }

    [[nodiscard]] std::optional<ClearPlace> clear_place(const std::vector<PictureBox>& boxes,
                                                        double most) const {
        const std::vector<glm::dvec2> places = places_beside();
        for (double farther = 1.0; farther <= most; farther += farther_step)
            for (const glm::dvec2& beside : places)
                if (is_clear({farther, beside}, boxes)) return ClearPlace{farther, beside};
        return std::nullopt;
    }

    void move(std::vector<CameraPose>& poses, const ClearPlace& place) const {
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const One& one = poses_[i];
            const glm::dvec2 across = one.across(place);
            poses[i].look_at -= across.x * one.camera.right + across.y * one.camera.up;
            poses[i].eye = poses[i].look_at - place.farther * one.away * one.camera.forward;
        }
    }

    /// From the first pose.
    [[nodiscard]] std::vector<glm::dvec2> seen_corners() const { return poses_.front().seen({}); }

  private:
    struct One {
        Camera camera;
        double away;                      ///< from what is looked at, block lengths
        std::vector<glm::dvec3> corners;  ///< to the right, up and ahead
        glm::dvec2 reach;                 ///< how far from the middle they may be seen

        /// By how much the block lies to the right and up.
        [[nodiscard]] glm::dvec2 across(const ClearPlace& place) const {
            return place.farther * away * place.beside * glm::dvec2(camera.half.x, camera.half.y);
        }

        [[nodiscard]] std::vector<glm::dvec2> seen(const ClearPlace& place) const {
            const glm::dvec2 by = across(place);
            std::vector<glm::dvec2> places;
            for (const glm::dvec3& corner : corners) {
                const double depth = std::max(corner.z + (place.farther - 1.0) * away, 1e-6);
                places.push_back((glm::dvec2(corner) + by) /
                                 (depth * glm::dvec2(camera.half.x, camera.half.y)));
            }
            return places;
        }
    };

    [[nodiscard]] bool is_clear(const ClearPlace& place,
                                const std::vector<PictureBox>& boxes) const {
        return std::ranges::all_of(poses_, [&](const One& one) {
            const std::vector<glm::dvec2> seen = one.seen(place);
            return std::ranges::all_of(seen,
                                       [&](const glm::dvec2& point) {
                                           return std::abs(point.x) <= one.reach.x &&
                                                  std::abs(point.y) <= one.reach.y;
                                       }) &&
                   std::ranges::none_of(
                       boxes, [&](const PictureBox& box) { return hull_meets_box(seen, box); });
        });
    }

    std::vector<One> poses_;
};

/// The corners of the convex hull of points, counterclockwise (Andrew 1979).
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
    std::ranges::sort(points, [](const glm::dvec2& one, const glm::dvec2& other) {
        return one.x != other.x ? one.x < other.x : one.y < other.y;
    });
    const auto turns_left = [](const glm::dvec2& from, const glm::dvec2& at, const glm::dvec2& to) {
        const glm::dvec2 one = at - from;
        const glm::dvec2 other = to - at;
        return one.x * other.y - one.y * other.x > 0.0;
    };
    std::vector<glm::dvec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const glm::dvec2& point : points) {
            while (hull.size() >= first + 2 &&
                   !turns_left(hull[hull.size() - 2], hull[hull.size() - 1], point))
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

}  // namespace

bool hull_meets_box(const std::vector<glm::dvec2>& points, const PictureBox& box) {
    const std::array<glm::dvec2, 2> sides{{{1.0, 0.0}, {0.0, 1.0}}};
    if (std::ranges::any_of(sides,
                            [&](const glm::dvec2& side) { return are_parted(points, box, side); }))
        return false;
    const std::vector<glm::dvec2> hull = hull_of(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        if (are_parted(hull, box, {-edge.y, edge.x})) return false;
    }
    return true;
}

std::vector<CameraPose> clear_poses(const FilmStage& stage, std::vector<CameraPose> poses) {
    const PosesInView view(stage, poses);
    std::vector<PictureBox> boxes = boxes_in_view(stage.kept_clear);
    const std::size_t needed = boxes.size();
    for (const PictureBox& box : boxes_in_view(stage.captions)) boxes.push_back(box);
    if (boxes.empty()) return poses;
    std::optional<ClearPlace> place = view.clear_place(boxes, most_farther_for_captions);
    if (!place) {
        boxes.resize(needed);
        place = view.clear_place(boxes, most_farther);
    }
    if (place) view.move(poses, *place);
    return poses;
}

bool is_covered(const FilmStage& stage, const CameraPose& pose) {
    const std::vector<glm::dvec2> seen = PosesInView(stage, {pose}).seen_corners();
    return std::ranges::any_of(stage.kept_clear,
                               [&](const PictureBox& box) { return hull_meets_box(seen, box); });
}

}  // namespace fumon
