#include "models/water/edge_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fumon {
namespace {

constexpr double g = 9.81;

TEST(EdgeFlow, RootsOfCelerityAreRoots) {
    for (const double b : {-40.0, -3.0, -0.2, 0.0, 0.3, 12.0}) {
        for (const double d : {1e-9, 1e-3, 1.0, 400.0}) {
            const double c = root_of_celerity(2.0, b, d);
            EXPECT_GT(c, 0.0);
            EXPECT_NEAR(c * c * (2.0 * c + b), d, 1e-9 * (d + c * c * c + std::fabs(b) * c * c));
        }
    }
    EXPECT_NEAR(root_of_celerity(1.0, 0.0, 27.0), 3.0, 1e-14);
}

TEST(EdgeFlow, AUniformSubcriticalFlowPassesUnchanged) {
    const double h = 1.7;
    const double u = 1.1;
    const EdgeFlux in = discharge_through_edge({h, -u, 0.3, 5.0}, h * u, 0.0, g);
    EXPECT_EQ(in.mass, -h * u);
    EXPECT_NEAR(in.momentum, h * u * u + 0.5 * g * h * h, 1e-12);
    EXPECT_EQ(in.along, 0.0);
    const EdgeFlux out = level_at_edge({h, u, 0.3, 5.0}, 5.0 + h, g);
    EXPECT_NEAR(out.mass, h * u, 1e-12);
    EXPECT_NEAR(out.momentum, h * u * u + 0.5 * g * h * h, 1e-12);
    EXPECT_NEAR(out.along, 0.3 * h * u, 1e-12);
}

TEST(EdgeFlow, SupercriticalFlowsComeAndGoAsTheyAre) {
    const EdgeFlux in = discharge_through_edge({0.3, -1.0, 0.0, 0.0}, 2.0, 0.4, g);
    EXPECT_EQ(in.mass, -2.0);
    EXPECT_NEAR(in.momentum, 2.0 * 2.0 / 0.4 + 0.5 * g * 0.16, 1e-12);
    const EdgeFlux out = level_at_edge({0.4, 5.0, 0.0, 0.0}, 0.5, g);
    EXPECT_NEAR(out.mass, 2.0, 1e-12);
}

TEST(EdgeFlow, OntoDryGroundADischargeComesInCritical) {
    const EdgeFlux in = discharge_through_edge({}, 2.0, 0.0, g);
    const double h = std::cbrt(4.0 / g);
    EXPECT_EQ(in.mass, -2.0);
    EXPECT_NEAR(in.momentum, 4.0 / h + 0.5 * g * h * h, 1e-9);
}

TEST(EdgeFlow, OverAFallWaterLeavesCriticalAndNoneComesIn) {
    const double nowhere = -std::numeric_limits<double>::infinity();
    const EdgeFlux still = level_at_edge({0.9, 0.0, 0.0, 1.0}, nowhere, g);
    const double c = 2.0 / 3.0 * std::sqrt(g * 0.9);
    EXPECT_NEAR(still.mass, c * c * c / g, 1e-12);
    EXPECT_EQ(level_at_edge({0.9, -7.0, 0.0, 1.0}, nowhere, g).mass, 0.0);
    EXPECT_NEAR(level_at_edge({0.9, 5.0, 0.0, 1.0}, nowhere, g).mass, 4.5, 1e-12);
}

TEST(EdgeFlow, WaterAtRestAtItsLevelStays) {
    const EdgeFlux rest = level_at_edge({0.8, 0.0, 0.0, 0.2}, 1.0, g);
    EXPECT_NEAR(rest.mass, 0.0, 1e-15);
    EXPECT_NEAR(rest.momentum, 0.5 * g * 0.64, 1e-12);
    const EdgeFlux none = discharge_through_edge({0.8, 0.0, 0.0, 0.2}, 0.0, 0.0, g);
    EXPECT_EQ(none.mass, 0.0);
    EXPECT_NEAR(none.momentum, 0.5 * g * 0.64, 1e-12);
    EXPECT_EQ(discharge_through_edge({}, 0.0, 0.0, g).mass, 0.0);
    EXPECT_EQ(level_at_edge({}, -1.0, g).mass, 0.0);
}

}  // namespace
}  // namespace fumon
