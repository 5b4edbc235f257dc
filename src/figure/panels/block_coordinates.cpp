#include "figure/panels/block_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace fumon {

namespace {

constexpr double plate_room_em = 0.18;      // around a text, font sizes
constexpr double least_change_share = 0.5;  // of an edge's length, in a coordinate that it shows

/// A lower edge of the block, from a corner to the next one counter-clockwise, block lengths.
struct Edge {
    glm::dvec2 from;
    glm::dvec2 to;
    glm::dvec2 outward;  ///< a unit vector

    Edge(const glm::dvec2& from_, const glm::dvec2& to_) : from(from_), to(to_), outward(0.0) {
        const glm::dvec2 along = to - from;
        outward = glm::dvec2(along.y, -along.x) / glm::length(along);
    }

    [[nodiscard]] glm::dvec3 point(const Block& block, double share, double beyond = 0.0) const {
        return {glm::mix(from, to, share) + beyond * outward, block.base};
    }
    /// How far the camera stands before the block's wall over it; of an orthographic one, how much
    /// the wall faces it.
    [[nodiscard]] double before(const Block& block, const Camera& camera) const {
        const glm::dvec3 out(outward, 0.0);
        if (!camera.perspective) return -glm::dot(out, camera.forward);
        return glm::dot(out, camera.eye - point(block, 0.5));
    }
    [[nodiscard]] bool shows(bool east) const {
        const glm::dvec2 along = glm::abs(to - from);
        return (east ? along.x : along.y) >= least_change_share * glm::length(along);
    }
};

/// The edges of the hull before which the camera stands; seen from above it, at least the nearest
/// ones that show the one and the other coordinate.
std::vector<Edge> near_edges(const Block& block, const Camera& camera) {
    const std::vector<glm::dvec2> hull = hull_of(block.outline);
    std::vector<Edge> all;
    for (std::size_t i = 0; i < hull.size(); ++i)
        all.emplace_back(hull[i], hull[(i + 1) % hull.size()]);
    std::vector<Edge> edges;
    for (const Edge& edge : all) {
        if (edge.before(block, camera) > 0.0) edges.push_back(edge);
    }
    for (const bool east : {true, false}) {
        const auto shows = [east](const Edge& edge) { return edge.shows(east); };
        if (std::ranges::any_of(edges, shows)) continue;
        const Edge* nearest = nullptr;
        for (const Edge& edge : all) {
            if (!shows(edge)) continue;
            if (nearest == nullptr || edge.before(block, camera) > nearest->before(block, camera))
                nearest = &edge;
        }
        if (nearest != nullptr) edges.push_back(*nearest);
    }
    return edges;
}

std::optional<CanvasPoint> seen(const ViewProjection& view, const glm::dvec3& point) {
    const Camera& camera = view.camera;
    if (camera.perspective && glm::dot(point - camera.eye, camera.forward) < camera.near_depth)
        return std::nullopt;
    return view.at(point);
}

/// Away from the block on the ground, as it is seen; downward where that is no direction.
CanvasPoint outward_of(const ViewProjection& view, const Edge& edge, double share) {
    constexpr double step = 1e-3;
    const CanvasPoint at = view.at(edge.point(view.block, share));
    const CanvasPoint beyond = view.at(edge.point(view.block, share, step));
    const glm::dvec2 way(beyond.x - at.x, beyond.y - at.y);
    const double length = glm::length(way);
    if (!(length > 1e-6)) return {0.0, 1.0};
    return {way.x / length, way.y / length};
}

/// An edge at a place along x or y, and the share of it there.
struct EdgePosition {
    const Edge* edge;
    double share;
};

std::optional<EdgePosition> position_on_edge(const std::vector<Edge>& edges, bool east,
                                             double place) {
    for (const Edge& edge : edges) {
        if (!edge.shows(east)) continue;
        const double from = east ? edge.from.x : edge.from.y;
        const double to = east ? edge.to.x : edge.to.y;
        const double share = (place - from) / (to - from);
        constexpr double rounding = 1e-9;
        if (share >= -rounding && share <= 1.0 + rounding) return EdgePosition{&edge, share};
    }
    return std::nullopt;
}

}  // namespace

/// By Andrew's monotone chain.
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
    std::ranges::sort(points, [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<glm::dvec2> hull;
    const auto turns_left = [&](const glm::dvec2& next) {
        const glm::dvec2 one = hull[hull.size() - 1] - hull[hull.size() - 2];
        const glm::dvec2 other = next - hull[hull.size() - 1];
        return one.x * other.y - one.y * other.x > 1e-12;
    };
    const auto add_chain = [&](auto begin, auto end) {
        const std::size_t start = hull.size();
        for (auto at = begin; at != end; ++at) {
            while (hull.size() >= start + 2 && !turns_left(*at)) hull.pop_back();
            hull.push_back(*at);
        }
        hull.pop_back();  // the other chain begins with it
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return hull;
}

BlockCoordinates block_coordinates(const ViewProjection& view, const WorldScale& scale,
                                   double length_x, double length_y) {
    BlockCoordinates coordinates;
    const std::vector<Edge> edges = near_edges(view.block, view.camera);
    for (const Edge& edge : edges) {
        constexpr int parts = 32;
        std::vector<CanvasPoint> line;
        for (int i = 0; i <= parts; ++i) {
            const auto point = seen(view, edge.point(view.block, static_cast<double>(i) / parts));
            if (point) line.push_back(*point);
        }
        if (line.size() > 1) coordinates.lines.push_back(std::move(line));
    }
    for (const bool east : {true, false}) {
        const double length = east ? length_x : length_y;
        const double width = east ? view.block.width_x : view.block.width_y;
        const auto found = [=](double place) {
            return position_on_edge(edges, east, (place / length - 0.5) * width);
        };
        CoordinateAxis axis{CoordinateScale(scale, east ? CoordinateScale::Axis::east
                                                        : CoordinateScale::Axis::north),
                            length,
                            {},
                            {},
                            false};
        axis.seen = [=](double place) -> std::optional<CanvasPoint> {
            const auto at = found(place);
            if (!at) return std::nullopt;
            return seen(view, at->edge->point(view.block, at->share));
        };
        axis.outward = [=](double place) -> CanvasPoint {
            const auto at = found(place);
            return at ? outward_of(view, *at->edge, at->share) : CanvasPoint{0.0, 1.0};
        };
        coordinates.axes.push_back(std::move(axis));
    }
    return coordinates;
}

void draw_coordinate_marks(Canvas& canvas, std::span<const CoordinateMark> marks, double plate) {
    for (const CoordinateMark& mark : marks) {
        const CanvasBox box = grown(mark.box, plate_room_em * canvas.font_size());
        if (plate > 0.0) canvas.fill(box, {1.0, 1.0, 1.0, plate});
        canvas.stroke(std::array{mark.from, mark.to}, canvas.line_width(), coordinate_ink);
        canvas.write(mark.text, mark.box.middle(), {0.5, 0.5}, black_ink, 1.0, mark.upright);
    }
}

}  // namespace fumon
