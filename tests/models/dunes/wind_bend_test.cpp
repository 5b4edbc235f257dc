#include "models/dunes/wind/wind_bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"
#include "models/dunes/wind/relief_shear.h"
#include "models/shared/state_hash.h"

namespace fumon::test {
namespace {

constexpr int nx = 96;
constexpr int ny = 64;
const DuneGround ground{nx, ny, 10.0, 10.0, true, true};

BlowingWind wind_from(double degrees) {
    return WindSchedule({{degrees, 1.0, 1.0}}, [](double) { return 1.0; }).at(0);
}

/// A wave of the ground with so many crests along x and y.
struct GroundWave {
    double crests_x;
    double crests_y;
    double height;  ///< m, half of crest to trough

    [[nodiscard]] double kx() const { return crests_x * 2.0 * std::acos(-1.0) / (nx * ground.dx); }
    [[nodiscard]] double ky() const { return crests_y * 2.0 * std::acos(-1.0) / (ny * ground.dy); }
    [[nodiscard]] double phase(int x, int y) const {
        return kx() * x * ground.dx + ky() * y * ground.dy;
    }
};

TEST(WindBend, StressAcrossTheWindIsThatOfTheLinearTheory) {
    WorkerPool pool(2);
    const GroundWave wave{3.0, -2.0, 4.0};
    const double k = std::hypot(wave.kx(), wave.ky());
    const double resolved = std::exp(-k * k * 10.0 * 10.0 / 8.0);
    ReliefShear shear(ground, 3.5, 2.0, pool);
    for (const double from : {270.0, 225.0, 10.0}) {
        const BlowingWind wind = wind_from(from);
        const double along = wave.kx() * wind.x + wave.ky() * wind.y;
        const double aside = wave.ky() * wind.x - wave.kx() * wind.y;
        Grid plane(nx, ny);
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) plane(x, y) = wave.height * std::cos(wave.phase(x, y));
        }
        shear.apply_across(plane, wind, 2.2);
        BentWind bent{Grid(nx, ny), Grid(nx, ny)};
        turn_by_stress(plane, wind, pool, bent);
        for (int y = 0; y < ny; y += 7) {
            for (int x = 0; x < nx; ++x) {
                const double stress =
                    2.2 * along * aside / k * wave.height * resolved * std::cos(wave.phase(x, y));
                ASSERT_NEAR(plane(x, y), stress, 1e-10);
                const double turned = std::atan2(wind.x * bent.y(x, y) - wind.y * bent.x(x, y),
                                                 wind.x * bent.x(x, y) + wind.y * bent.y(x, y));
                ASSERT_NEAR(std::tan(turned), stress, 1e-10);
                ASSERT_NEAR(std::hypot(bent.x(x, y), bent.y(x, y)), 1.0, 1e-12);
            }
        }
    }
}

TEST(WindBend, ContoursLeadTheWindAsPublished) {
    WorkerPool pool(2);
    const GroundWave wave{2.0, 1.0, 60.0};
    FixedPointGrid surface(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            surface(x, y) = to_units(wave.height * std::cos(wave.phase(x, y)));
    }
    const BlowingWind wind = wind_from(270.0);
    BentWind bent{Grid(nx, ny), Grid(nx, ny)};
    ContourBend(ground, pool).find(surface, wind, bent);
    const double squares = wave.kx() * wave.kx() + wave.ky() * wave.ky();
    double most = 0.0;
    for (int y = 0; y < ny; y += 5) {
        for (int x = 0; x < nx; ++x) {
            double along = 0.0;
            double across = 0.0;
            for (const auto& [sigma, weight, strength] :
                 {std::tuple{100.0, 0.8, 3.0}, std::tuple{25.0, 0.2, 0.5}}) {
                const double slope = -wave.height * std::exp(-0.5 * squares * sigma * sigma) *
                                     std::sin(wave.phase(x, y)) / 10.0;
                const double gx = slope * std::sin(wave.kx() * 10.0);
                const double gy = slope * std::sin(wave.ky() * 10.0);
                const double alpha = std::hypot(gx, gy);
                ASSERT_LT(alpha, 1.0);
                const double side = gy > 0.0 ? -1.0 : 1.0;  // so that it points along the wind
                along += weight * (1.0 - alpha - alpha * strength * side * gy);
                across += weight * alpha * strength * side * gx;
            }
            const double turned = std::atan2(across, along);
            ASSERT_NEAR(std::atan2(bent.y(x, y), bent.x(x, y)), turned, 1e-7);
            most = std::max(most, std::abs(turned));
        }
    }
    EXPECT_GT(most * degrees_per_radian, 2.0) << "or there is nothing to see";
}

DunesParameters bending(DuneBend bend) {
    DunesParameters parameters;
    parameters.wind_bend = bend;
    parameters.winds = {{255.0, 1.0, 1.0}};
    return parameters;
}

TEST(WindBend, FlatGroundTurnsNothing) {
    WorkerPool pool(1);
    std::vector<Sha256> hashes;
    for (const DuneBend bend : {DuneBend::none, DuneBend::shear, DuneBend::contours}) {
        Dunes dunes(bending(bend), {Grid(40, 24, 2.0), {}, {1.0, 1.0, 1.0, true}, 7, pool});
        for (int step = 0; step < 5; ++step) dunes.step();
        hashes.push_back(state_hash(dunes));
    }
    EXPECT_EQ(hashes[1], hashes[0]);
    EXPECT_EQ(hashes[2], hashes[0]);
}

/// How far sand in the air before the hill has come from its middle row, in parts of all of it.
double aside_before_hill(const DuneBed& bed) {
    double aside = 0.0;
    double sum = 0.0;
    for (int y = 0; y < ny; ++y) {
        for (int x = 20; x < 40; ++x) {
            aside += std::abs(y - 31.5) * to_metres(bed.moving(x, y));
            sum += to_metres(bed.moving(x, y));
        }
    }
    return aside / sum;
}

/// Outward before a hill and inward behind it, alike on both sides, and sand goes round.
TEST(WindBend, TheWindGoesRoundAHill) {
    WorkerPool pool(2);
    double straight = 0.0;
    for (const DuneBend bend : {DuneBend::none, DuneBend::shear, DuneBend::contours}) {
        DunesParameters parameters = bending(bend);
        parameters.winds = {{270.0, 1.0, 1.0}};
        parameters.saturation_length = {"hops", 0.0};
        parameters.hop_length = 20.0;
        parameters.shadow_soft_angle = 25.0;
        parameters.shadow_angle = 30.0;
        parameters.features = {
            {FeatureKind::rock, FeatureShape::hill, 480.0, 320.0, 400.0, 400.0, 50.0, 90.0}};
        Dunes dunes(parameters, {Grid(nx, ny, 0.5), {}, {10.0, 10.0, 1.0, true}, 7, pool});
        const Snapshot snapshot = dunes.snapshot();
        const Grid* turn = field_of(snapshot.fields, "wind_turn");
        ASSERT_EQ(turn == nullptr, bend == DuneBend::none);
        for (int step = 0; step < 10; ++step) dunes.step();
        if (bend == DuneBend::none) {
            straight = aside_before_hill(dunes.bed());
            continue;
        }
        EXPECT_GT(aside_before_hill(dunes.bed()), 1.001 * straight);
        const double before_left = (*turn)(38, 38);
        const double behind_left = (*turn)(57, 38);
        EXPECT_GT(before_left, 1.5);
        EXPECT_LT(before_left, 45.0);
        EXPECT_NEAR((*turn)(38, 25), -before_left, 1e-6);
        EXPECT_LT(behind_left, -1.0);
        EXPECT_NEAR((*turn)(57, 25), -behind_left, 1e-6);
    }
}

TEST(WindBend, IsOfContinuousTransportWithRelief) {
    WorkerPool pool(1);
    for (const bool slabs : {true, false}) {
        DunesParameters parameters = bending(DuneBend::shear);
        parameters.speed_up = DuneSpeedUp::none;
        if (slabs) parameters.transport = DuneTransport::slabs;
        try {
            const Dunes dunes(parameters, {Grid(40, 24, 2.0), {}, {1.0, 1.0, 1.0, true}, 7, pool});
            FAIL() << "no KeyError";
        } catch (const KeyError& error) {
            EXPECT_EQ(error.key(), "model.wind_bend");
        }
    }
}

/// On a plane that rises across any wind, hops come down by D of the slope.
TEST(WindBend, SlopesAcrossTheWindDeflectHops) {
    WorkerPool pool(2);
    DuneGround open = ground;
    open.periodic_x = false;
    open.periodic_y = false;
    constexpr double rise_x = 0.03;
    constexpr double rise_y = -0.2;
    FixedPointGrid plane(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) plane(x, y) = to_units(10.0 * (rise_x * x + rise_y * y));
    }
    for (const double from : {270.0, 200.0, 20.0}) {
        const BlowingWind wind = wind_from(from);
        Grid across(nx, ny, 0.01);
        turn_down_slopes(plane, open, wind, 0.4, pool, across);
        const double slope = wind.x * rise_y - wind.y * rise_x;
        for (const int x : {0, 40, nx - 1}) {
            for (const int y : {0, 30, ny - 1})
                EXPECT_NEAR(across(x, y), 0.01 - 0.4 * slope, 1e-9) << from;
        }
    }
}

/// Width and height of a lone barchan as field dunes have them, W = 8.6 H + 8.8 m, within 15 %.
TEST(WindBend, DeflectedHopsWidenBarchans) {
    WorkerPool pool(1);
    const auto over_field = [&] {
        DunesParameters dunes;
        dunes.slope_deflection = 0.2;
        dunes.features = {
            {FeatureKind::sand, FeatureShape::hill, 30.0, 36.0, 35.0, 35.0, 3.5, 90.0}};
        dunes.edges_x = DuneEdge::open;
        dunes.influx = 0.2;
        Dunes model(dunes, {Grid(140, 72), {}, {1.0, 1.0, 1.0, true}, 7, pool});
        for (int step = 0; step < 2000; ++step) model.step();
        double height = 0.0;
        int first = 72;
        int last = 0;
        for (int y = 0; y < 72; ++y) {
            for (const std::int64_t surface : model.bed().surface.row(y)) {
                height = std::max(height, to_metres(surface));
                if (to_metres(surface) < 0.1) continue;
                first = std::min(first, y);
                last = y;
            }
        }
        return (last + 1 - first) / (8.6 * height + 8.8);
    };
    EXPECT_NEAR(over_field(), 1.0, 0.15) << ".68 without deflection";
}

}  // namespace
}  // namespace fumon::test
