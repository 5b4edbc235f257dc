#include "models/air/air_poisson.h"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/worker_pool.h"

namespace fumon {
namespace {

AirPlane ripples(int nx, int nz, double height) {
    AirPlane plane;
    plane.nx = nx;
    plane.nz = nz;
    plane.spacing = 1.0;
    for (int i = 0; i < nx; ++i) {
        const double h = height * (1.0 + std::cos(2.0 * std::numbers::pi * i / nx));
        plane.height.push_back(h);
        plane.under_bed.push_back(static_cast<int>(std::floor(h + on_bed_tolerance)));
    }
    plane.largest_height = 2.0 * height;
    return plane;
}

/// A right-hand side without symmetry, whose values at nodes of the bed must not matter.
std::vector<double> rough_side(const AirPlane& plane) {
    std::vector<double> side(plane.at(plane.nx, 0));
    for (std::size_t n = 0; n < side.size(); ++n)
        side[n] = std::sin(0.7 * static_cast<double>(n * n % 101));
    return side;
}

class AirPoissonOn : public testing::TestWithParam<int> {};

/// Eigen's LU of the same equations with that of node 0 pinned, less what a constant adds.
TEST_P(AirPoissonOn, AgreesWithALUFactorisation) {
    const int nx = GetParam();
    const AirPlane plane = ripples(nx, 19, nx < 10 ? 0.4 : 0.05 * nx);
    std::vector<int> number(plane.at(plane.nx, 0), -1);
    std::vector<std::size_t> nodes;
    const auto lowest = [&](int i) { return plane.under_bed[static_cast<std::size_t>(i)] + 1; };
    for (int i = 0; i < nx; ++i) {
        for (int k = lowest(i); k < plane.nz; ++k) {
            number[plane.at(i, k)] = static_cast<int>(nodes.size());
            nodes.push_back(plane.at(i, k));
        }
    }
    std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};
    for (int i = 0; i < nx; ++i) {
        for (int k = lowest(i); k < plane.nz; ++k) {
            for (const PressureTerm& term : pressure_equation(plane, BedPressure::one_sided, i, k))
                entries.emplace_back(number[plane.at(i, k)], number[plane.at(term.i, term.k)],
                                     term.weight);
        }
    }
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
    const std::vector<double> side = rough_side(plane);
    Eigen::VectorXd known(count);
    for (Eigen::Index n = 0; n < count; ++n) known[n] = side[nodes[static_cast<std::size_t>(n)]];
    const Eigen::VectorXd pinned = factors.solve(known);
    const Eigen::VectorXd of_one = factors.solve(Eigen::VectorXd::Ones(count));
    const Eigen::VectorXd expected = pinned - pinned[0] / of_one[0] * of_one;

    WorkerPool pool(1);
    AirPoisson poisson(plane, BedPressure::one_sided, pool);
    std::vector<double> pressure(side.size());
    poisson.solve(side, pressure);
    const double size = expected.cwiseAbs().maxCoeff();
    for (Eigen::Index n = 0; n < count; ++n)
        ASSERT_NEAR(pressure[nodes[static_cast<std::size_t>(n)]], expected[n], 1e-10 * size);
}

// Every radix of the transform, odd and prime lengths.
INSTANTIATE_TEST_SUITE_P(Lengths, AirPoissonOn, testing::Values(4, 5, 8, 9, 50, 60, 77, 97, 100),
                         [](const auto& test) { return std::to_string(test.param); });

/// Over a level bed p = cos(2πi/n)·cosh-like modes of the difference equation itself.
TEST(AirPoisson, SolvesAManufacturedField) {
    const AirPlane plane = ripples(24, 17, 0.0);
    const auto field = [&](int i, int k) {
        return std::cos(2.0 * std::numbers::pi * i / plane.nx) * (0.1 * k * k - 0.3 * k) + 0.2 * k;
    };
    std::vector<double> side(plane.at(plane.nx, 0));
    for (int i = 0; i < plane.nx; ++i) {
        for (int k = 1; k < plane.nz; ++k) {
            for (const PressureTerm& term : pressure_equation(plane, BedPressure::one_sided, i, k))
                side[plane.at(i, k)] += term.weight * field(term.i, term.k);
        }
    }
    WorkerPool pool(1);
    AirPoisson poisson(plane, BedPressure::one_sided, pool);
    std::vector<double> pressure(side.size());
    poisson.solve(side, pressure);
    for (int i = 0; i < plane.nx; ++i) {
        for (int k = 1; k < plane.nz; ++k)
            ASSERT_NEAR(pressure[plane.at(i, k)], field(i, k) - field(0, 1), 1e-11);
    }
}

/// Rounding follows the blocks into which Eigen cuts a matrix, and they would follow the
/// processor's caches.
TEST(AirPoisson, DoesNotDependOnTheProcessorsCaches) {
    WorkerPool pool(1);
    const AirPoisson poisson(ripples(8, 5, 0.5), BedPressure::one_sided, pool);
    EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
    EXPECT_EQ(Eigen::l2CacheSize(), 256 * 1024);
}

}  // namespace
}  // namespace fumon
