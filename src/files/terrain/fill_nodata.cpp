#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"

namespace fumon {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

constexpr std::size_t largest_direct =
    300'000;                          // hole cells, 2 s; the time grows faster than they do
constexpr double residual = 1e-9;     // relative, where the iteration stops
constexpr int most_iterations = 300;  // 2 s per million hole cells

bool is_hole(const Mask& nodata, int x, int y) {
    return nodata(x, y) != 0;
}

/// One equation per hole cell: (number of neighbours)·h − Σ neighbouring holes = Σ neighbouring
/// data. A neighbour beyond the grid's edge is left out, which is the condition of no slope there.
struct LaplaceProblem {
    Matrix matrix;
    Vector right_side;
    std::vector<std::pair<int, int>> holes;
};

LaplaceProblem laplace_problem(const Grid& heights, const Mask& nodata) {
    LaplaceProblem problem;
    Field<int> number(nodata.nx(), nodata.ny(), -1);
    for (int y = 0; y < nodata.ny(); ++y) {
        for (int x = 0; x < nodata.nx(); ++x) {
            if (!is_hole(nodata, x, y)) continue;
            number(x, y) = static_cast<int>(problem.holes.size());
            problem.holes.emplace_back(x, y);
        }
    }
    constexpr std::array<std::pair<int, int>, 4> around{{{0, -1}, {-1, 0}, {1, 0}, {0, 1}}};
    const auto count = static_cast<int>(problem.holes.size());
    problem.matrix.resize(count, count);
    problem.matrix.reserve(Eigen::VectorXi::Constant(count, 5));
    problem.right_side = Vector::Zero(count);
    for (int i = 0; i < count; ++i) {
        const auto [x, y] = problem.holes[static_cast<std::size_t>(i)];
        int neighbours = 0;
        for (const auto& [east, north] : around) {
            const int xn = x + east;
            const int yn = y + north;
            if (xn < 0 || yn < 0 || xn >= nodata.nx() || yn >= nodata.ny()) continue;
            ++neighbours;
            if (is_hole(nodata, xn, yn)) {
                problem.matrix.insert(number(xn, yn), i) = -1.0;
            } else {
                problem.right_side[i] += heights(xn, yn);
            }
        }
        problem.matrix.insert(i, i) = neighbours;
    }
    problem.matrix.makeCompressed();
    return problem;
}

/// Means of the data cells in blocks of 2 × 2; a block without any is a hole.
std::pair<Grid, Mask> coarser(const Grid& heights, const Mask& nodata) {
    const int nx = (heights.nx() + 1) / 2;
    const int ny = (heights.ny() + 1) / 2;
    Grid sums(nx, ny);
    Field<int> counts(nx, ny);
    for (int y = 0; y < heights.ny(); ++y) {
        for (int x = 0; x < heights.nx(); ++x) {
            if (is_hole(nodata, x, y)) continue;
            sums(x / 2, y / 2) += heights(x, y);
            ++counts(x / 2, y / 2);
        }
    }
    Mask holes(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (counts(x, y) > 0) sums(x, y) /= counts(x, y);
            holes(x, y) = counts(x, y) == 0 ? 1 : 0;
        }
    }
    return {std::move(sums), std::move(holes)};
}

/// The coarser grid's value at the centre of a finer cell, bilinear between the four nearest
/// blocks.
double interpolated(const Grid& coarse, int x, int y) {
    const int x1 = std::clamp(x / 2 + (x % 2 == 0 ? -1 : 1), 0, coarse.nx() - 1);
    const int y1 = std::clamp(y / 2 + (y % 2 == 0 ? -1 : 1), 0, coarse.ny() - 1);
    const double near_row = 0.75 * coarse(x / 2, y / 2) + 0.25 * coarse(x1, y / 2);
    const double far_row = 0.75 * coarse(x / 2, y1) + 0.25 * coarse(x1, y1);
    return 0.75 * near_row + 0.25 * far_row;
}

Vector solve(const Grid& heights, const Mask& nodata, const LaplaceProblem& problem) {
    if (problem.holes.size() <= largest_direct) {
        const Eigen::SimplicialLDLT<Matrix> factors(problem.matrix);
        if (factors.info() != Eigen::Success) throw Error("no-data cells cannot be filled");
        return factors.solve(problem.right_side);
    }
    // The coarser grid's filling is right at large scale, where the iteration is slow.
    const auto [coarse_heights, coarse_nodata] = coarser(heights, nodata);
    const Grid coarse = fill_nodata(coarse_heights, coarse_nodata);
    Vector start(problem.right_side.size());
    for (std::size_t i = 0; i < problem.holes.size(); ++i) {
        const auto [x, y] = problem.holes[i];
        start[static_cast<Eigen::Index>(i)] = interpolated(coarse, x, y);
    }
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> iteration;
    iteration.setTolerance(residual);
    iteration.setMaxIterations(most_iterations);
    iteration.compute(problem.matrix);
    return iteration.solveWithGuess(problem.right_side, start);
}

}  // namespace

Grid fill_nodata(const Grid& heights, const Mask& nodata) {
    const auto mask = nodata.values();
    const auto outside =
        std::count_if(mask.begin(), mask.end(), [](auto cell) { return cell != 0; });
    if (outside == 0) return heights;
    if (static_cast<std::size_t>(outside) == heights.size())
        throw InputError(
            "every cell is no-data, so there is nothing to fill from; give a terrain with at least "
            "one height");
    const LaplaceProblem problem = laplace_problem(heights, nodata);
    const Vector filled = solve(heights, nodata, problem);
    Grid result = heights;
    for (std::size_t i = 0; i < problem.holes.size(); ++i) {
        const auto [x, y] = problem.holes[i];
        result(x, y) = filled[static_cast<Eigen::Index>(i)];
    }
    return result;
}

}  // namespace fumon
