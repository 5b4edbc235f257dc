#include "measure/pile/cone.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

namespace {

struct CoveredCell {
    double x, y, height;
};

struct ConeProfile {
    double height = 0.0;  ///< at r = 0
    double slope = 0.0;   ///< downward
    double residual = 0.0;
    bool exists = false;
};

std::vector<CoveredCell> covered_cells(const Grid& bed) {
    std::vector<CoveredCell> cells;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double height = bed(x, y);
            if (height > 0.0)
                cells.push_back({static_cast<double>(x), static_cast<double>(y), height});
        }
    }
    return cells;
}

double distance(const CoveredCell& cell, BedPoint apex) {
    return std::sqrt((cell.x - apex.x) * (cell.x - apex.x) + (cell.y - apex.y) * (cell.y - apex.y));
}

double mean_height(const std::vector<CoveredCell>& cells) {
    double sum = 0.0;
    for (const auto& cell : cells) sum += cell.height;
    return sum / static_cast<double>(cells.size());
}

double squares_about_mean(const std::vector<CoveredCell>& cells) {
    const double mean = mean_height(cells);
    double squares = 0.0;
    for (const auto& cell : cells) squares += (cell.height - mean) * (cell.height - mean);
    return squares;
}

/// Height and slope of the best cone with this apex.
ConeProfile best_line(const std::vector<CoveredCell>& cells, BedPoint apex) {
    const double mean = mean_height(cells);
    double mean_distance = 0.0;
    for (const auto& cell : cells) mean_distance += distance(cell, apex);
    mean_distance /= static_cast<double>(cells.size());
    double spread = 0.0;
    double together = 0.0;
    for (const auto& cell : cells) {
        const double away = distance(cell, apex) - mean_distance;
        spread += away * away;
        together += away * (cell.height - mean);
    }
    constexpr double rounding =
        1e-12;  // squared cells a cell: distances that differ by less do not
    ConeProfile line;
    line.exists = spread > rounding * static_cast<double>(cells.size());
    if (!line.exists) return line;
    line.slope = -together / spread;
    line.height = mean + line.slope * mean_distance;
    for (const auto& cell : cells) {
        const double off = cell.height - (line.height - line.slope * distance(cell, apex));
        line.residual += off * off;
    }
    return line;
}

ConeFit cone_of(BedPoint apex, const ConeProfile& line, double squares) {
    return {apex, line.height, line.slope, degrees_per_radian * elementary::atan(line.slope),
            1.0 - line.residual / squares};
}

/// The damped Gauss–Newton step of the apex: the normal equations of (height, slope, x, y).
BedPoint apex_step(const std::vector<CoveredCell>& cells, BedPoint apex, const ConeProfile& line,
                   double damping) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const auto& cell : cells) {
        const double r = distance(cell, apex);
        const double pull = r > 0.0 ? line.slope / r : 0.0;  // at the tip every direction is down
        const Eigen::Vector4d gradient(1.0, -r, pull * (cell.x - apex.x), pull * (cell.y - apex.y));
        normal += gradient * gradient.transpose();
        right += gradient * (cell.height - (line.height - line.slope * r));
    }
    const double least = 1e-14 * normal.trace();  // a ridge one cell wide pulls nowhere across
    for (int i = 0; i < 4; ++i) normal(i, i) += damping * normal(i, i) + least;
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    return {step(2), step(3)};
}

BedPoint centroid(const std::vector<CoveredCell>& cells) {
    double total = 0.0;
    BedPoint sum;
    for (const auto& cell : cells) {
        total += cell.height;
        sum.x += cell.height * cell.x;
        sum.y += cell.height * cell.y;
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
    const ConeProfile line = best_line(cells, apex);
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
    ConeProfile line = best_line(cells, apex);
    if (!(squares > 0.0) || !line.exists) return {};
    double damping = 1e-3;
    for (int i = 0; i < most_steps && damping < firmest; ++i) {
        const BedPoint step = apex_step(cells, apex, line, damping);
        const BedPoint next{apex.x + step.x, apex.y + step.y};
        const bool near = lies_on(bed, next, 2.0 * (bed.nx() + bed.ny()));
        const ConeProfile tried = near ? best_line(cells, next) : ConeProfile{};
        if (tried.exists && tried.residual < line.residual) {
            apex = next;
            line = tried;
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
