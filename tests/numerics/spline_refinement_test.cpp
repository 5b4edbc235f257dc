#include "numerics/spline_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "numerics/resampling.h"

namespace fumon {
namespace {

Grid hilly(int nx, int ny) {
    Grid hills(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            hills(x, y) = 3.0 * std::sin(0.7 * x) * std::cos(0.9 * y) + ((7 * x + 3 * y) % 5);
    }
    return hills;
}

TEST(SplineRefinement, PassesThroughItsCellsAndKeepsPlanesToTheirEdges) {
    const Grid hills = hilly(9, 7);
    const Grid fine = spline_refined(hills, 3);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) EXPECT_NEAR(fine(3 * x + 1, 3 * y + 1), hills(x, y), 1e-12);
    for (const int side : {1, 2, 3, 6}) {
        Grid plane(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) plane(x, y) = 2.0 * x - 5.0 * y;
        const Grid finer = spline_refined(plane, 4);
        const double slope = side > 1 ? 1.0 : 0.0;
        for (int y = 0; y < finer.ny(); ++y) {
            for (int x = 0; x < finer.nx(); ++x)
                EXPECT_NEAR(finer(x, y), slope * (2.0 * (x - 1.5) - 5.0 * (y - 1.5)) / 4.0, 1e-12)
                    << side << " cells";
        }
    }
}

/// The largest jump of curvature from cell to cell along the rows of a finer bed, in parts of the
/// largest curvature there.
double curvature_jump(const Grid& fine) {
    double jump = 0.0;
    double most = 0.0;
    for (int y = 0; y < fine.ny(); ++y) {
        const auto curvature = [&](int x) {
            return fine(x - 1, y) - 2.0 * fine(x, y) + fine(x + 1, y);
        };
        for (int x = 1; x + 2 < fine.nx(); ++x) {
            jump = std::max(jump, std::fabs(curvature(x + 1) - curvature(x)));
            most = std::max(most, std::fabs(curvature(x)));
        }
    }
    return jump / most;
}

TEST(SplineRefinement, HasNoJumpsOfCurvatureBetweenCells) {
    const Grid hills = hilly(20, 16);
    constexpr int finer = 16;
    EXPECT_LT(curvature_jump(spline_refined(hills, finer)), 0.15) << "1 / 16, and what bends";
    EXPECT_GT(curvature_jump(refined(hills, finer)), 0.3) << "what the bicubic leaves";
}

}  // namespace
}  // namespace fumon
