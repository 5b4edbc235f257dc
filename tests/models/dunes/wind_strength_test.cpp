// Winds of dunes given by a speed or a friction velocity, against the saturated flux worked out by
// hand, with the integral of its law by quadrature.

#include "models/dunes/wind/wind_strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

struct SpeedAndFlux {
    double speed;              ///< m/s, 10 m above the ground
    double friction_velocity;  ///< m/s
    double flux;               ///< m²/yr
};

/// Of sand of 0.25 mm and a roughness of 1 mm, whose threshold is u*t = 0.20254 m/s.
constexpr SpeedAndFlux by_hand[] = {{5.0, 0.217147, 13.5355},
                                    {6.0, 0.260577, 60.7145},
                                    {7.0, 0.304006, 118.7018},
                                    {10.0, 0.434294, 363.2305}};
constexpr double threshold = 0.202544;  // m/s

DuneWind of_speed(double speed, double duration = 1.0, double from = 270.0) {
    DuneWind wind;
    wind.from = from;
    wind.speed = speed;
    wind.duration = duration;
    return wind;
}

DunesParameters under(std::vector<DuneWind> winds) {
    DunesParameters dunes;
    dunes.winds = std::move(winds);
    return dunes;
}

ModelSetup box_of(Grid bed, WorkerPool& pool) {
    return {std::move(bed), {}, {1.0, 1.0, 1.0, true}, 7, pool};
}

/// Low hills of sand, flatter than the angle of repose.
Grid hills(int nx = 40, int ny = 24) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            bed(x, y) = 2.0 + 0.4 * std::sin(0.31 * x) + 0.3 * std::cos(0.26 * y + 0.16 * x);
    }
    return bed;
}

TEST(WindStrength, IsTheSaturatedFluxOfASpeed) {
    for (const SpeedAndFlux& one : by_hand) {
        DunesParameters dunes = under({of_speed(one.speed)});
        dunes.flux = 40.0;
        const DuneWind wind = with_wind_strengths(dunes).winds.at(0);
        EXPECT_NEAR(wind.strength * dunes.flux / one.flux, 1.0, 1e-5) << one.speed;
        EXPECT_NEAR(wind.threshold_ratio.value, one.friction_velocity / threshold, 1e-5);
    }
}

TEST(WindStrength, IsTheSameByFrictionVelocityAndBySpeedsAtOtherHeights) {
    for (const SpeedAndFlux& one : by_hand) {
        DuneWind low = of_speed(one.friction_velocity / 0.4 * std::log(2.0 / 1e-3));
        low.speed_height = 2.0;
        DuneWind by_friction;
        by_friction.friction_velocity = one.friction_velocity;
        const auto winds = with_wind_strengths(under({low, by_friction})).winds;
        EXPECT_NEAR(winds[0].strength / winds[1].strength, 1.0, 1e-9);
        EXPECT_NEAR(winds[1].strength * 100.0 / one.flux, 1.0, 2e-5);
    }
}

TEST(WindStrength, CoarserSandNeedsMoreWindAndRoughGroundBrakesMore) {
    DunesParameters dunes = under({of_speed(7.0)});
    dunes.grain_diameter = 0.5;  // u*t = 0.2864 m/s, √2 of the other
    EXPECT_NEAR(with_wind_strengths(dunes).winds[0].threshold_ratio.value, 0.304006 / 0.286441,
                1e-4);
    dunes.grain_diameter = 0.25;
    dunes.roughness = 1e-2;  // u* = 0.4 × 7 / ln 1000
    EXPECT_NEAR(with_wind_strengths(dunes).winds[0].threshold_ratio.value, 0.405343 / threshold,
                1e-4);
}

TEST(WindStrength, WindsUpToTheThresholdAreCalms) {
    for (const double speed : {0.0, 3.0, 4.6}) {
        const DuneWind calm = with_wind_strengths(under({of_speed(speed)})).winds.at(0);
        EXPECT_EQ(calm.strength, 0.0) << speed;
        EXPECT_TRUE(calm.threshold_ratio.is_word());
    }
    EXPECT_GT(with_wind_strengths(under({of_speed(4.7)})).winds.at(0).strength, 0.0);
}

TEST(WindStrength, CalmsMoveNoSand) {
    DunesParameters dunes = under({of_speed(4.0)});
    dunes.edges_x = DuneEdge::open;
    dunes.influx = 0.7;
    WorkerPool pool(2);
    Dunes model(dunes, box_of(hills(), pool));
    const FixedPointGrid before = model.bed().surface;
    for (int n = 0; n < 20; ++n) model.step();
    EXPECT_EQ(model.bed().surface, before);
    EXPECT_EQ(model.bed().moving, FixedPointGrid(before.nx(), before.ny()));
    EXPECT_EQ(model.bed().inflow, 0);
    EXPECT_EQ(model.snapshot().winds.at(0).drift, 0.0);
    EXPECT_GT(model.time(), 0.0);
}

TEST(WindStrength, ASpeedIsTheStrengthAndThresholdThatFollowFromIt) {
    DunesParameters speeds = under({of_speed(7.0, 0.002), of_speed(10.0, 0.001, 200.0)});
    speeds.flux = 64.0;
    DunesParameters strengths = speeds;
    strengths.winds = with_wind_strengths(speeds).winds;
    for (DuneWind& wind : strengths.winds) wind.speed = {"none", 0.0};
    ASSERT_GT(strengths.winds[0].strength, 1.0);
    DunesParameters other_unit = speeds;
    other_unit.flux = 32.0;
    DunesParameters no_threshold = speeds;
    for (DuneWind& wind : no_threshold.winds) wind.threshold_ratio = {"none", 0.0};
    WorkerPool pool(2);
    const auto after = [&](const DunesParameters& dunes) {
        Dunes model(dunes, box_of(hills(), pool));
        for (int n = 0; n < 30; ++n) model.step();
        return model.bed().surface;
    };
    const FixedPointGrid grown = after(speeds);
    EXPECT_EQ(grown, after(strengths));
    EXPECT_EQ(grown, after(other_unit)) << "model.flux is only the unit of strengths";
    EXPECT_NE(grown, after(no_threshold));
}

TEST(WindStrength, ARunTellsWhatItsWindsMove) {
    WorkerPool pool(1);
    const Dunes model(under({of_speed(10.0, 0.25), of_speed(6.0, 0.5, 180.0), of_speed(2.0, 0.25)}),
                      box_of(hills(), pool));
    const std::vector<SnapshotWind> winds = model.snapshot().winds;
    ASSERT_EQ(winds.size(), 3U);
    EXPECT_NEAR(winds[0].drift, 363.2305 / 4.0, 1e-3);
    EXPECT_NEAR(winds[1].drift, 60.7145 / 2.0, 1e-3);
    EXPECT_EQ(winds[2].drift, 0.0);
    EXPECT_EQ(winds[1].y, 1.0);
}

TEST(WindStrength, WhatContradictsIsRefused) {
    const auto refusal = [](const DuneWind& wind, DuneTransport transport) {
        DunesParameters dunes = under({wind});
        dunes.transport = transport;
        return message_of<KeyError>([&] { with_wind_strengths(dunes); });
    };
    DuneWind wind = of_speed(7.0);
    EXPECT_EQ(refusal(wind, DuneTransport::slabs), "");
    wind.strength = 0.5;
    EXPECT_NE(refusal(wind, DuneTransport::continuous).find("strength = 0.5 beside a speed"),
              std::string::npos);
    wind.strength = 1.0;
    wind.friction_velocity = 0.3;
    EXPECT_NE(refusal(wind, DuneTransport::continuous).find("keep one"), std::string::npos);
    wind.friction_velocity = {"none", 0.0};
    wind.speed_height = 1e-3;
    EXPECT_NE(refusal(wind, DuneTransport::continuous).find("lie within model.roughness"),
              std::string::npos);
    EXPECT_NE(refusal(of_speed(3.0), DuneTransport::slabs).find("moves no sand"),
              std::string::npos);
}

}  // namespace
}  // namespace fumon::test
