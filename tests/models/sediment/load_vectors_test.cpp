#include "models/sediment/load_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/worker_pool.h"
#include "models/sediment/bank_collapse.h"

namespace fumon::test {
namespace {

/// What a cell gives, under half a metre of water that runs at (0.6, −0.8) m/s over a bed that
/// rises by these slopes toward x and y.
struct Given {
    double x, y, down, entrainment, pace;
};
Given given(const loads::PickUpLaw& law, double rise_x, double rise_y, double friction = 0.005) {
    const double depth = 0.5;
    const double u = 0.6;
    const double v = -0.8;
    const std::array<double, 3> bed{-rise_x, 0.0, rise_x};
    const double south = -rise_y;
    Given is{};
    loads::pick_up_row(law, {&depth, &u, &v, &friction, bed.data() + 1, &south, &rise_y}, 2.0, 2.0,
                       1, {&is.x, &is.y, &is.down, &is.entrainment, &is.pace});
    return is;
}

loads::PickUpLaw law_of_sand() {
    loads::PickUpLaw law;
    law.per_stress = 20.0;  // θ = 0.1 of friction 0.005
    law.critical = 0.05;
    law.unit = 0.001;
    law.half_per_x = law.half_per_y = 0.5;
    law.per_tangent = 1.0 / 0.6;
    law.turning = 0.4;
    law.entrainment = 1e-5;
    law.per_entrainment_stress = 400.0;  // τ is twice τ_e
    return law;
}

TEST(LoadVectors, GiveWhatTheLawsSay) {
    loads::PickUpLaw law = law_of_sand();
    const Given level = given(law, 0.0, 0.0);
    const double q = 0.001 * 8.0 * std::pow(0.05, 1.5);
    EXPECT_NEAR(level.x, 0.6 * q, 1e-12 * q);
    EXPECT_NEAR(level.y, -0.8 * q, 1e-12 * q);
    EXPECT_NEAR(level.down, 0.4 * q / std::sqrt(0.1), 1e-12 * q);
    EXPECT_NEAR(level.entrainment, 1e-5, 1e-17);
    EXPECT_NEAR(level.pace, 3.0 * 2.0 * q / 0.5 + 2.0 * 2.0 * level.down + 1e-5 / 0.55, 1e-12);

    const Given downhill = given(law, -0.06, 0.08);  // 0.1 down the flow
    const double eased = 0.001 * 8.0 * std::pow(0.1 - 0.05 * (1.0 - 0.1 / 0.6), 1.5);
    EXPECT_NEAR(downhill.x, 0.6 * eased, 1e-12 * q);
    law.slope_x = 0.06;  // the mean plane takes that away
    law.slope_y = -0.08;
    EXPECT_NEAR(given(law, -0.06, 0.08).x, 0.6 * q, 1e-12 * q);

    law = law_of_sand();
    law.ashida_michiue = true;
    const double japanese = 0.001 * 17.0 * std::pow(0.1, 1.5) * 0.5 * (1.0 - std::sqrt(0.5));
    EXPECT_NEAR(given(law, 0.0, 0.0).x, 0.6 * japanese, 1e-12 * q);
    law.critical = 0.11;
    EXPECT_EQ(given(law, 0.0, 0.0).x, 0.0) << "below the threshold";

    law = law_of_sand();
    law.manning = true;
    EXPECT_NEAR(given(law, 0.0, 0.0, 0.005 * std::cbrt(0.5)).x, 0.6 * q, 1e-9 * q)
        << "the same stress";
}

TEST(LoadVectors, PassThroughFacesFromUpstreamAndDownTheSlope) {
    const std::array<double, 2> along_low{2.0, -1.0};
    const std::array<double, 2> along_high{3.0, -4.0};
    const std::array<double, 2> down_low{0.5, 0.0};
    const std::array<double, 2> down_high{1.5, 0.0};
    const std::array<double, 2> bed_low{0.0, 0.0};
    const std::array<double, 2> bed_high{0.2, 5.0};
    std::array<double, 2> flux{};
    loads::face_row({along_low.data(), along_high.data(), down_low.data(), down_high.data(),
                     bed_low.data(), bed_high.data()},
                    10.0, -0.5, 2, flux.data());
    EXPECT_DOUBLE_EQ(flux[0], 2.0 - 1.0 * (2.0 - 0.5));
    EXPECT_DOUBLE_EQ(flux[1], -4.0);
}

TEST(BankCollapse, LeavesNoSlopeSteeperThanTheAngleOfReposeWithThePlane) {
    WorkerPool pool(1);
    LoadGround ground;
    ground.nx = 21;
    ground.ny = 25;
    ground.slope = 0.3;
    Grid bed(21, 25);
    bed(10, 12) = 8.0;
    bed(4, 4) = 2.0;
    ground.nodata = Mask(21, 25);
    ground.nodata(4, 5) = 1;
    bed(4, 5) = -9999.0;
    const Grid none;
    BankCollapse banks(ground, 35.0, none, pool);
    for (int time = 0; time < 20; ++time) banks.fail(bed);
    EXPECT_EQ(bed(4, 5), -9999.0);
    double sum = 0.0;
    double steepest = 0.0;
    for (int y = 1; y < 24; ++y) {
        for (int x = 1; x < 20; ++x) {
            if (x == 4 && y == 5) continue;
            sum += bed(x, y);
            if (std::abs(x - 4) < 3 && std::abs(y - 5) < 3) continue;
            const double plane = 0.3;
            const double a = std::max({bed(x, y) - bed(x - 1, y), bed(x, y) - bed(x + 1, y), 0.0});
            const double b = std::max(
                {bed(x, y) - bed(x, y - 1) + plane, bed(x, y) - bed(x, y + 1) - plane, 0.0});
            steepest = std::max(steepest, std::hypot(a, b));
        }
    }
    EXPECT_NEAR(sum, 10.0, 1e-9);
    EXPECT_LT(steepest, std::tan(35.5 * 3.14159265 / 180.0));
    EXPECT_GT(steepest, std::tan(33.0 * 3.14159265 / 180.0));
}

}  // namespace
}  // namespace fumon::test
