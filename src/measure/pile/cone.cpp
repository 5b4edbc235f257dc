#include "measure/pile/cone.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

namespace {

/// The cells with something on them.
struct CoveredCells {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> height;
    double mean_height = 0.0;

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

struct ConeProfile {
    double height = 0.0;  ///< at r = 0
    double slope = 0.0;   ///< downward
    double residual = 0.0;
    bool exists = false;
};

CoveredCells covered_cells(const Grid& bed) {
    CoveredCells cells;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double height = bed(x, y);
            if (!(height > 0.0)) continue;
            cells.x.push_back(x);
            cells.y.push_back(y);
            cells.height.push_back(height);
        }
    }
    double sum = 0.0;
    for (const double height : cells.height) sum += height;
    cells.mean_height = sum / static_cast<double>(cells.size());
    return cells;
}

/// Of each cell from an apex.
void find_distances(const CoveredCells& cells, BedPoint apex, std::vector<double>& distances) {
    distances.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double east = cells.x[i] - apex.x;
        const double north = cells.y[i] - apex.y;
        distances[i] = std::sqrt(east * east + north * north);
    }
}

double squares_about_mean(const CoveredCells& cells) {
    const double mean = cells.mean_height;
    double squares = 0.0;
    for (const double height : cells.height) squares += (height - mean) * (height - mean);
    return squares;
}

/// Height and slope of the best cone with this apex, at these distances from it.
ConeProfile best_line(const CoveredCells& cells, const std::vector<double>& distances) {
    const double mean = cells.mean_height;
    double mean_distance = 0.0;
    for (const double distance : distances) mean_distance += distance;
    mean_distance /= static_cast<double>(cells.size());
    double spread = 0.0;
    double together = 0.0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double away = distances[i] - mean_distance;
        spread += away * away;
        together += away * (cells.height[i] - mean);
    }
    constexpr double rounding =
        1e-12;  // squared cells a cell: distances that differ by less do not
    ConeProfile line;
    line.exists = spread > rounding * static_cast<double>(cells.size());
    if (!line.exists) return line;
    line.slope = -together / spread;
    line.height = mean + line.slope * mean_distance;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double off = cells.height[i] - (line.height - line.slope * distances[i]);
        line.residual += off * off;
    }
    return line;
}

ConeFit cone_of(BedPoint apex, const ConeProfile& line, double squares) {
    return {apex, line.height, line.slope, degrees_per_radian * elementary::atan(line.slope),
            1.0 - line.residual / squares};
}

/// The damped Gauss–Newton step of the apex: the normal equations of (height, slope, x, y).
BedPoint apex_step(const CoveredCells& cells, const std::vector<double>& distances, BedPoint apex,
                   const ConeProfile& line, double damping) {
    double sums[4][4] = {};
    double right_sums[4] = {};
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const double r = distances[k];
        const double pull = r > 0.0 ? line.slope / r : 0.0;  // at the tip every direction is down
        const double gradient[4] = {1.0, -r, pull * (cells.x[k] - apex.x),
                                    pull * (cells.y[k] - apex.y)};
        const double off = cells.height[k] - (line.height - line.slope * r);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j <= i; ++j) sums[i][j] += gradient[i] * gradient[j];
            right_sums[i] += gradient[i] * off;
        }
    }
    Eigen::Matrix4d normal;
    Eigen::Vector4d right;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = sums[i][j];
        right(i) = right_sums[i];
    }
    const double least = 1e-14 * normal.trace();  // a ridge one cell wide pulls nowhere across
    for (int i = 0; i < 4; ++i) normal(i, i) += damping * normal(i, i) + least;
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    return {step(2), step(3)};
}

BedPoint centroid(const CoveredCells& cells) {
    double total = 0.0;
    BedPoint sum;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        total += cells.height[i];
        sum.x += cells.height[i] * cells.x[i];
        sum.y += cells.height[i] * cells.y[i];
    }
    return {sum.x / total, sum.y / total};
}

bool lies_on(const Grid& bed, BedPoint point, double margin) {
    return point.x >= -0.5 - margin && point.x <= bed.nx() - 0.5 + margin &&
           point.y >= -0.5 - margin && point.y <= bed.ny() - 0.5 + margin;
}

}  // namespace

ConeFit cone_at(const Grid& bed, BedPoint apex) {
    constexpr std::size_t fewest = 3;
    const auto cells = covered_cells(bed);
    if (cells.size() < fewest) return {};
    const double squares = squares_about_mean(cells);
    std::vector<double> distances;
    find_distances(cells, apex, distances);
    const ConeProfile line = best_line(cells, distances);
    if (!(squares > 0.0) || !line.exists) return {};
    return cone_of(apex, line, squares);
}

ConeFit free_cone(const Grid& bed) {
    constexpr std::size_t fewest = 5;
    constexpr int most_steps = 500;
    constexpr double still = 1e-10;  // cells: a step below this ends the search
    constexpr double gentlest = 1e-12;
    constexpr double firmest = 1e12;
    constexpr double firmer = 4.0;
    const auto cells = covered_cells(bed);
    if (cells.size() < fewest) return {};
    const double squares = squares_about_mean(cells);
    BedPoint apex = centroid(cells);
    std::vector<double> distances;
    std::vector<double> tried_distances;
    find_distances(cells, apex, distances);
    ConeProfile line = best_line(cells, distances);
    if (!(squares > 0.0) || !line.exists) return {};
    double damping = 1e-3;
    for (int i = 0; i < most_steps && damping < firmest; ++i) {
        const BedPoint step = apex_step(cells, distances, apex, line, damping);
        const BedPoint next{apex.x + step.x, apex.y + step.y};
        const bool near = lies_on(bed, next, 2.0 * (bed.nx() + bed.ny()));
        ConeProfile tried;
        if (near) {
            find_distances(cells, next, tried_distances);
            tried = best_line(cells, tried_distances);
        }
        if (tried.exists && tried.residual < line.residual) {
            apex = next;
            line = tried;
            std::swap(distances, tried_distances);
            damping = std::max(gentlest, damping / firmer);
            if (std::abs(step.x) + std::abs(step.y) < still) break;
        } else {
            damping *= firmer;
        }
    }
    if (!lies_on(bed, apex, 0.0)) return {};
    return cone_of(apex, line, squares);
}

}  // namespace fumon
