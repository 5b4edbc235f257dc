// What faces see of cells that hold means (models/water/kernels/mean_vectors.h).

#include "models/water/kernels/mean_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "models/water/kernels/limited_slope_vectors.h"

namespace fumon {
namespace {

using finite_volume::CellRow;
using finite_volume::HalfSlopes;

constexpr std::size_t mean_cells = 13;  // no whole number of vectors
using MeanCells = std::array<double, mean_cells + 2>;

/// Rows of cells, what limited slopes they have, and what their faces see.
struct MeanFlow {
    MeanCells depth{};
    MeanCells surface{};
    MeanCells carried{};
    MeanCells still{};
    MeanCells inside{};
    std::array<MeanCells, 4> slopes{};
    std::array<MeanCells, 5> seen{};

    void look() {
        inside.fill(1.0);
        const auto from = [&](std::size_t k) {
            return CellRow{depth.data() + k, surface.data() + k, carried.data() + k,
                           still.data() + k, inside.data() + k};
        };
        const HalfSlopes half{slopes[0].data() + 1, slopes[1].data() + 1, slopes[2].data() + 1,
                              slopes[3].data() + 1, nullptr};
        const auto count = static_cast<int>(mean_cells);
        finite_volume::limited_half_slopes(from(0), from(1), from(2), {0.0, 9.81, 1.3, false}, half,
                                           count);
        finite_volume::means_to_faces(from(0), from(1), from(2), half,
                                      {seen[0].data() + 1, seen[1].data() + 1, seen[2].data() + 1,
                                       seen[3].data() + 1, seen[4].data() + 1},
                                      count);
    }
};

TEST(MeansToFaces, OfAParabolaWithLinearVelocityAreItsValuesThere) {
    const auto level = [](double x) { return 3.0 + 0.2 * x - 0.002 * x * x; };
    const auto bed = [](double x) { return 0.4 - 0.1 * x + 0.001 * x * x; };
    const auto velocity = [](double x) { return 0.4 + 0.1 * x; };
    const auto mean = [](const auto& of, double x) {  // Simpson's rule, which is exact here
        return (of(x - 0.5) + 4.0 * of(x) + of(x + 0.5)) / 6.0;
    };
    MeanFlow flow;
    const auto place = [](std::size_t k) { return static_cast<double>(k) - 7.3; };
    for (std::size_t k = 0; k < flow.depth.size(); ++k) {
        const double x = place(k);
        flow.surface[k] = mean(level, x);
        flow.depth[k] = flow.surface[k] - mean(bed, x);
        const auto momentum = [&](double at) { return (level(at) - bed(at)) * velocity(at); };
        flow.carried[k] = mean(momentum, x) / flow.depth[k];
    }
    flow.look();
    for (std::size_t k = 1; k <= mean_cells; ++k) {
        const double x = place(k);
        for (const double side : {-1.0, 1.0}) {
            const double face = x + 0.5 * side;
            const auto at_face = [&](std::size_t of) {
                return flow.seen[of][k] + side * flow.slopes[of][k];
            };
            EXPECT_NEAR(at_face(0), level(face) - bed(face), 1e-13) << x;
            EXPECT_NEAR(at_face(1), level(face), 1e-13) << x;
            EXPECT_NEAR(at_face(2), velocity(face), 1e-13) << x;
        }
        const auto pull = [&](double at) {  // depth times the surface's slope
            return (level(at) - bed(at)) * (0.2 - 0.004 * at);
        };
        EXPECT_NEAR(2.0 * flow.seen[4][k] * flow.depth[k], mean(pull, x), 1e-13) << x;
        EXPECT_EQ(flow.seen[3][k], 0.0);
    }
}

TEST(MeansToFaces, AreBoundedAtFrontsAndThoseOfPlainCellsInThinWater) {
    MeanFlow front;
    for (std::size_t k = 0; k < front.depth.size(); ++k) {
        front.depth[k] = k < 5 ? 1e-5 : 2.0 + 0.06 * static_cast<double>(k);
        front.carried[k] = k < 5 ? 0.0 : 1.0 + 0.1 * static_cast<double>(k);
    }
    front.surface = front.depth;
    front.look();
    for (std::size_t k = 1; k <= mean_cells; ++k) {
        for (const double side : {-1.0, 1.0}) {
            const double depth = front.seen[0][k] + side * front.slopes[0][k];
            const double velocity = front.seen[2][k] + side * front.slopes[2][k];
            EXPECT_GE(depth, 0.0) << k;
            EXPECT_GE(velocity, 0.0) << k;
            EXPECT_LE(velocity, 0.1 + front.carried[k + (side > 0.0 ? 1 : 0)]) << k;
        }
    }
    MeanFlow thin;
    for (std::size_t k = 0; k < thin.depth.size(); ++k) {
        const auto x = static_cast<double>(k);
        thin.depth[k] = 0.1 + 0.001 * x * x;
        thin.surface[k] = thin.depth[k] + 0.6 * x;
        thin.carried[k] = 0.3 + 0.02 * x;
    }
    thin.look();
    EXPECT_EQ(thin.seen[0][3], thin.depth[3]);
    EXPECT_EQ(thin.seen[1][3], thin.surface[3]);
    EXPECT_EQ(thin.seen[2][3], thin.carried[3]);
    EXPECT_EQ(thin.seen[4][3], thin.slopes[1][3]);
}

}  // namespace
}  // namespace fumon
