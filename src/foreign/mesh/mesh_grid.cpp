#include "foreign/mesh/mesh_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fumon {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t outside = -1;

/// Twice the area of a triangle, positive counter-clockwise.
double doubled_area(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
}

int cells_over(const std::vector<double>& places, const std::vector<std::int32_t>& corners,
               double cell) {
    double farthest = 0.0;
    for (const std::int32_t node : corners)
        farthest = std::max(farthest, places[static_cast<std::size_t>(node)]);
    // A mesh a rounding error wider than whole cells needs no further one.
    constexpr double tolerance = 1e-6;
    return std::max(1, static_cast<int>(std::ceil(farthest / cell - tolerance)));
}

}  // namespace

MeshGrid::MeshGrid(FaceMesh mesh, double cell) : mesh_(std::move(mesh)), cell_(cell) {
    faces_ = Field<std::int32_t>(cells_over(mesh_.x, mesh_.corners, cell),
                                 cells_over(mesh_.y, mesh_.corners, cell), outside);
    for (std::size_t face = 0; face < mesh_.faces(); ++face) fill(face);
}

/// The cells of a face, a row after the other: those between the places where its edges cross the
/// row's centres. An edge has the same crossing in both of its faces, so that none is left out.
void MeshGrid::fill(std::size_t face) {
    const auto corners = mesh_.face(face);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::int32_t node : corners) {
        low = std::min(low, mesh_.y[static_cast<std::size_t>(node)]);
        high = std::max(high, mesh_.y[static_cast<std::size_t>(node)]);
    }
    const auto row_at = [&](double y) {
        return std::clamp(static_cast<int>(std::ceil(y / cell_ - 0.5)), 0, ny());
    };
    const int end = row_at(high);
    for (int row = row_at(low); row < end; ++row) {
        const double y = (row + 0.5) * cell_;
        crossings_.clear();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            auto a = static_cast<std::size_t>(corners[k]);
            auto b = static_cast<std::size_t>(corners[(k + 1) % corners.size()]);
            if (a > b) std::swap(a, b);
            if ((mesh_.y[a] <= y) == (mesh_.y[b] <= y)) continue;
            const double share = (y - mesh_.y[a]) / (mesh_.y[b] - mesh_.y[a]);
            crossings_.push_back(mesh_.x[a] + share * (mesh_.x[b] - mesh_.x[a]));
        }
        std::ranges::sort(crossings_);
        for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
            const auto column_at = [&](double x) {
                return std::clamp(static_cast<int>(std::ceil(x / cell_ - 0.5)), 0, nx());
            };
            const int last = column_at(crossings_[k + 1]);
            for (int column = column_at(crossings_[k]); column < last; ++column)
                faces_(column, row) = static_cast<std::int32_t>(face);
        }
    }
}

/// By the triangle of a face that a place lies in, or least outside of.
MeshGrid::Weights MeshGrid::weights_at(std::size_t face, double x, double y) const {
    const auto corners = mesh_.face(face);
    const auto place = [&](std::size_t k) {
        const auto node = static_cast<std::size_t>(corners[k]);
        return std::pair(mesh_.x[node], mesh_.y[node]);
    };
    const auto [ax, ay] = place(0);
    Weights best;
    double best_least = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const auto [bx, by] = place(k);
        const auto [cx, cy] = place(k + 1);
        const double area = doubled_area(ax, ay, bx, by, cx, cy);
        if (area == 0.0) continue;
        const double second = doubled_area(ax, ay, x, y, cx, cy) / area;
        const double third = doubled_area(ax, ay, bx, by, x, y) / area;
        const double least = std::min({1.0 - second - third, second, third});
        if (least <= best_least) continue;
        best_least = least;
        best = {static_cast<std::uint32_t>(k), static_cast<float>(std::clamp(second, 0.0, 1.0)),
                static_cast<float>(std::clamp(third, 0.0, 1.0))};
    }
    return best;
}

void MeshGrid::find_weights() const {
    if (!weights_.empty()) return;
    weights_.resize(faces_.size());
    for (int row = 0; row < ny(); ++row) {
        for (int column = 0; column < nx(); ++column) {
            const std::int32_t face = faces_(column, row);
            if (face == outside) continue;
            weights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(nx()) +
                     static_cast<std::size_t>(column)] =
                weights_at(static_cast<std::size_t>(face), (column + 0.5) * cell_,
                           (row + 0.5) * cell_);
        }
    }
}

/// The sum over all triangles of their area times their mean, which is 0 where it is NaN.
template <class Mean>
double MeshGrid::integral(const Mean& mean_of) const {
    double sum = 0.0;
    for (std::size_t face = 0; face < mesh_.faces(); ++face) {
        const auto corners = mesh_.face(face);
        double area = 0.0;
        double of_face = 0.0;
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const std::array<std::size_t, 3> nodes{static_cast<std::size_t>(corners[0]),
                                                   static_cast<std::size_t>(corners[k]),
                                                   static_cast<std::size_t>(corners[k + 1])};
            const double part =
                0.5 * doubled_area(mesh_.x[nodes[0]], mesh_.y[nodes[0]], mesh_.x[nodes[1]],
                                   mesh_.y[nodes[1]], mesh_.x[nodes[2]], mesh_.y[nodes[2]]);
            const double mean = mean_of(face, nodes);
            area += part;
            if (std::isfinite(mean)) of_face += part * mean;
        }
        sum += area < 0.0 ? -of_face : of_face;
    }
    return sum;
}

Grid MeshGrid::of_faces(std::span<const double> values) const {
    Grid grid(nx(), ny(), none);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const std::int32_t face = faces_.values()[i];
        if (face != outside) grid.values()[i] = values[static_cast<std::size_t>(face)];
    }
    return grid;
}

Grid MeshGrid::of_nodes(std::span<const double> values) const {
    find_weights();
    Grid grid(nx(), ny(), none);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const std::int32_t face = faces_.values()[i];
        if (face == outside) continue;
        const auto corners = mesh_.face(static_cast<std::size_t>(face));
        const Weights& weights = weights_[i];
        const auto value = [&](std::size_t k) {
            return values[static_cast<std::size_t>(corners[k])];
        };
        const double first = value(0);
        grid.values()[i] = first + double{weights.share_second} * (value(weights.second) - first) +
                           double{weights.share_third} * (value(weights.second + 1) - first);
    }
    return grid;
}

double MeshGrid::integral_of_faces(std::span<const double> values) const {
    return integral([&](std::size_t face, const auto&) { return values[face]; });
}

double MeshGrid::integral_of_nodes(std::span<const double> values) const {
    return integral([&](std::size_t, const std::array<std::size_t, 3>& nodes) {
        return (values[nodes[0]] + values[nodes[1]] + values[nodes[2]]) / 3.0;
    });
}

}  // namespace fumon
