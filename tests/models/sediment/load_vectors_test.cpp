#include "models/sediment/load_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/sediment/bank_collapse.h"

namespace fumon::test {
namespace {

/// What a cell gives, under half a metre of water that runs at (0.6, −0.8) m/s over a bed that
/// rises by these slopes toward x and y.
struct Given {
    double x, y, down, entrainment, bed_rate;
};
Given given(const loads::PickUpLaw& law, double rise_x, double rise_y, double friction = 0.005) {
    const double depth = 0.5;
    const double u = 0.6;
    const double v = -0.8;
    const std::array<double, 3> bed{-rise_x, 0.0, rise_x};
    const double south = -rise_y;
    Given is{};
    loads::pick_up_row(law, {&depth, &u, &v, &friction, bed.data() + 1, &south, &rise_y}, 2.0, 2.0,
                       1, {&is.x, &is.y, &is.down, &is.entrainment, &is.bed_rate});
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
    EXPECT_NEAR(level.bed_rate, 3.0 * 2.0 * q / 0.5 + 2.0 * 2.0 * level.down + 1e-5 / 0.55, 1e-12);

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

// Without bed load the law asks for a root only where the water takes something up.
TEST(LoadVectors, TakeUpTheSameBesideWaterThatTakesUpNothing) {
    constexpr int cells = 101;
    std::array<double, cells> depth{};
    std::array<double, cells> u{};
    std::array<double, cells> friction{};
    const std::array<double, cells> v{};
    const std::array<double, cells + 2> bed{};
    RandomStream random(1, 0, 0, Purpose::initial_bed);
    for (std::size_t x = 0; x < cells; ++x) {
        depth[x] = x % 7 == 0 ? 0.0 : random.uniform();
        friction[x] = 0.01 * (0.5 + random.uniform());
        // τ/ρ from nearly that of entrainment, 0.0025, to a little more, by stretches
        const double over = x / 20 % 2 == 0 ? 1.0 - 1e-3 * random.uniform()
                                            : 1.0 + 1e-14 * (random.uniform() - 0.5);
        u[x] = std::sqrt(0.0025 * over * std::cbrt(depth[x]) / friction[x]);
    }
    loads::PickUpLaw law = law_of_sand();
    law.manning = true;
    std::array<std::array<double, cells>, 7> out{};
    const auto pick_up = [&](std::size_t first) {
        loads::pick_up_row(law,
                           {depth.data(), u.data(), v.data(), friction.data(), bed.data() + 1,
                            bed.data(), bed.data()},
                           2.0, 2.0, cells,
                           {out[4].data(), out[5].data(), out[6].data(), out[first].data(),
                            out[first + 1].data()});
    };
    pick_up(0);
    law.unit = 0.0;  // no bed load
    out[2].fill(1.0);
    pick_up(2);
    EXPECT_EQ(out[0], out[2]);
    const auto moves = [](double entrainment) { return entrainment > 0.0; };
    const auto moving = std::ranges::count_if(out[2], moves);
    EXPECT_GT(moving, 5);
    EXPECT_LT(moving, 40);
    for (std::size_t x = 0; x < cells; ++x) EXPECT_EQ(out[3][x] > 0.0, moves(out[2][x])) << x;
}

TEST(LoadVectors, LetAFadedLoadSettleAtOnce) {
    // What remains of four loads: too little; enough; less than nothing, by rounding; nothing.
    std::array<double, 4> load{3e-100, 5e-100, -1e-20, 0.0};
    std::array<double, 4> bed{};
    const std::array<double, 4> depth{1.0, 1.0, 1.0, 1.0};
    loads::SettlingFactors factors;
    factors.dt = 1.0;
    factors.settling = 3.0;  // a quarter stays
    loads::settle_row({depth.data(), nullptr, nullptr, nullptr, nullptr, nullptr}, factors, 4,
                      load.data(), bed.data());
    EXPECT_EQ(load[0], 0.0);
    EXPECT_EQ(bed[0], 3e-100) << "all of it, so that nothing is lost";
    EXPECT_DOUBLE_EQ(load[1], 1.25e-100);
    EXPECT_DOUBLE_EQ(load[2], -0.25e-20);
    EXPECT_EQ(load[3], 0.0);
}

TEST(LoadVectors, HoldEntrainmentAboveAFloor) {
    const std::array<double, 3> floor{1.0, 1.0, 1.0};
    const std::array<double, 3> bed{3.0, 1.5, 0.5};
    std::array<double, 3> entrainment{1.0, 1.0, 1.0};
    loads::hold_above_row(floor.data(), bed.data(), 0.75, 3, entrainment.data());
    EXPECT_EQ(entrainment, (std::array<double, 3>{1.0, 0.375, 0.0}));
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
