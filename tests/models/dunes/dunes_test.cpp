#include "models/dunes/dunes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/worker_pool.h"
#include "models/shared/state_hash.h"
#include "support/temporary_folder.h"
#include "support/uneven_bed.h"

namespace fumon::test {
namespace {

ModelSetup setup(Grid bed, WorkerPool& pool, double cell = 1.0) {
    return {std::move(bed), {}, {cell, cell, 1.0, true}, 7, pool};
}

std::int64_t sum(const FixedPointGrid& grid) {
    return std::accumulate(grid.values().begin(), grid.values().end(), std::int64_t{0});
}

/// Sand at rest and moving, and what has left, less what has come.
std::int64_t accounted(const DuneBed& bed) {
    return sum(bed.surface) - sum(bed.rock) + sum(bed.moving) + bed.outflow - bed.inflow;
}

struct Kind {
    std::string name;
    DunesParameters parameters;
};

std::vector<Kind> kinds() {
    std::vector<Kind> all;
    for (const DuneSpeedUp speed_up :
         {DuneSpeedUp::none, DuneSpeedUp::height, DuneSpeedUp::relief}) {
        DunesParameters dunes;
        dunes.speed_up = speed_up;
        dunes.winds = {{270.0, 1.0, 0.003}, {30.0, 0.7, 0.002}, {135.0, 1.4, 0.002}};
        all.push_back({"continuous " + std::to_string(static_cast<int>(speed_up)), dunes});
        dunes.saturation_length = {"hops", 0.0};
        all.push_back({all.back().name + " of hops", dunes});
        dunes.saturation_length = {"auto", 0.0};
        dunes.edges_x = DuneEdge::open;
        dunes.edges_y = DuneEdge::open;
        dunes.influx = 0.6;
        all.push_back({all.back().name + " open", dunes});
        for (const DuneBend bend : {DuneBend::shear, DuneBend::contours}) {
            if (speed_up != DuneSpeedUp::relief) continue;
            dunes.wind_bend = bend;
            all.push_back({"bent " + std::to_string(static_cast<int>(bend)), dunes});
        }
        if (speed_up == DuneSpeedUp::relief) {
            dunes.windward_angle = {"", 16.7};
            all.push_back({"with windward bubbles", dunes});
        }
        if (speed_up == DuneSpeedUp::relief) continue;
        dunes.transport = DuneTransport::slabs;
        dunes.hop_length = 5.0;
        dunes.winds = {{270.0, 1.0, 0.05}, {30.0, 1.0, 0.05}};
        all.push_back({"slabs open", dunes});
        dunes.edges_x = DuneEdge::periodic;
        dunes.edges_y = DuneEdge::periodic;
        all.push_back({"slabs", dunes});
        dunes.order = SlabOrder::sequential;
        dunes.influx = 0.0;
        all.push_back({"slabs one by one", dunes});
    }
    return all;
}

TEST(Dunes, SandIsConservedToTheLastUnitInEveryStep) {
    WorkerPool pool(2);
    for (const Kind& kind : kinds()) {
        SCOPED_TRACE(kind.name);
        Dunes dunes(kind.parameters, setup(uneven_bed(48, 40, 1.5), pool));
        const std::int64_t at_first = accounted(dunes.bed());
        for (int step = 0; step < 24; ++step) {
            dunes.step();
            ASSERT_EQ(accounted(dunes.bed()), at_first) << step;
        }
        const bool open = kind.parameters.edges_x == DuneEdge::open;
        EXPECT_EQ(dunes.bed().outflow > 0, open);
        EXPECT_EQ(dunes.bed().inflow > 0, open);
        for (std::size_t cell = 0; cell < dunes.bed().surface.size(); ++cell) {
            ASSERT_GE(dunes.bed().surface.values()[cell], dunes.bed().rock.values()[cell]);
            ASSERT_GE(dunes.bed().moving.values()[cell], 0);
        }
        EXPECT_EQ(dunes.plausibility_warning(), "");
    }
}

TEST(Dunes, AnyNumberOfThreadsGivesTheSameBytes) {
    for (const Kind& kind : kinds()) {
        SCOPED_TRACE(kind.name);
        std::vector<Sha256> hashes;
        for (const int threads : {1, 2, 5}) {
            WorkerPool pool(threads);
            Dunes dunes(kind.parameters, setup(uneven_bed(70, 64, 1.5), pool));
            for (int step = 0; step < 8; ++step) dunes.step();
            hashes.push_back(state_hash(dunes));
        }
        EXPECT_EQ(hashes[0], hashes[1]);
        EXPECT_EQ(hashes[0], hashes[2]);
    }
}

TEST(Dunes, NoSlopeExceedsTheAngleOfRepose) {
    WorkerPool pool(2);
    for (const Kind& kind : kinds()) {
        SCOPED_TRACE(kind.name);
        Dunes dunes(kind.parameters, setup(uneven_bed(40, 40, 3.0), pool));
        const bool periodic = kind.parameters.edges_x == DuneEdge::periodic;
        const SlopeRelaxation slopes({40, 40, 1.0, 1.0, periodic, periodic}, {}, pool);
        for (int step = 0; step < 12; ++step) {
            dunes.step();
            ASSERT_LE(slopes.steepest(dunes.bed().surface, dunes.bed().rock), 33.5);
        }
    }
}

/// Over flat sand the drift is what was asked for, wherever the wind blows.
TEST(Dunes, FlatSandDriftsAtTheSaturatedFlux) {
    WorkerPool pool(1);
    for (const double from : {270.0, 240.0, 0.0}) {
        DunesParameters dunes;
        dunes.winds = {{from, 1.5, 1.0}};
        dunes.flux = 80.0;
        dunes.saturation_length = {"hops", 0.0};
        dunes.hop_length = 2.5;
        dunes.time_step = 0.0004;
        Dunes model(dunes, setup(Grid(32, 24, 1.0), pool, 0.8));
        for (int step = 0; step < 60; ++step) model.step();
        // What stayed in the air and what is lifted hop together.
        const double in_air = to_metres(model.bed().moving(5, 5));
        const double lifted = 1.5 * 80.0 * 0.0004 * 0.6 / 2.5;
        EXPECT_NEAR((in_air + lifted) * 2.5 / 0.0004, 1.5 * 80.0, 1e-3) << from;
        EXPECT_NEAR(to_metres(model.bed().surface(5, 5)), 1.0 - in_air, 1e-6);
    }
}

/// A single wave, for which the stress is known.
TEST(Dunes, ShearStressLeadsTheCrests) {
    WorkerPool pool(2);
    constexpr int nx = 60;
    constexpr int ny = 44;
    const DuneGround ground{nx, ny, 2.0, 3.0, true, true};
    for (const auto& [m, n] :
         {std::pair{3, 0}, std::pair{0, 2}, std::pair{2, 3}, std::pair{-2, 1}, std::pair{5, -4}}) {
        for (const double from : {270.0, 200.0}) {
            const WindSchedule turns({{from, 1.0, 1.0}}, [](double) { return 1.0; });
            const BlowingWind wind = turns.at(0);
            const double pi = std::acos(-1.0);
            const double kx = 2.0 * pi * m / (nx * 2.0);
            const double ky = 2.0 * pi * n / (ny * 3.0);
            const double length = std::hypot(kx, ky);
            const double along = kx * wind.x + ky * wind.y;
            const double kept = std::exp(-(4.0 * kx * kx + 9.0 * ky * ky) / 8.0) * along / length;
            Grid plane(nx, ny);
            for (int y = 0; y < ny; ++y) {
                for (int x = 0; x < nx; ++x)
                    plane(x, y) = 0.7 + 0.1 * std::cos(kx * 2.0 * x + ky * 3.0 * y);
            }
            ReliefShear(ground, 3.5, 2.0, pool).apply(plane, wind);
            for (const auto& [x, y] : {std::pair{0, 0}, std::pair{7, 31}, std::pair{41, 12}}) {
                const double phase = kx * 2.0 * x + ky * 3.0 * y;
                const double expected =
                    0.1 * kept *
                    (3.5 * along * std::cos(phase) - 2.0 * std::abs(along) * std::sin(phase));
                EXPECT_NEAR(plane(x, y), expected, 1e-12) << m << ", " << n << ", " << from;
            }
        }
    }
}

/// Grids whose rows are no multiple of what the transform takes at once.
TEST(Dunes, ShearStressForgetsEarlierBeds) {
    WorkerPool pool(1);
    for (const int nx : {59, 60, 61, 64}) {
        const DuneGround ground{nx, 30, 1.0, 1.0, true, true};
        const WindSchedule turns({{250.0, 1.0, 1.0}}, [](double) { return 1.0; });
        ReliefShear shear(ground, 3.5, 2.0, pool);
        const Grid bed = uneven_bed(nx, 30, 2.0);
        Grid first = bed;
        shear.apply(first, turns.at(0));
        for (int n = 0; n < 250; ++n) {
            Grid again = bed;
            shear.apply(again, turns.at(0));
            if (n % 50 != 0 && n != 249) continue;
            ASSERT_TRUE(std::ranges::equal(again.values(), first.values())) << nx << ", " << n;
        }
    }
}

TEST(Dunes, WindsBlowInTurn) {
    const WindSchedule turns({{270.0, 1.0, 0.5}, {0.0, 2.0, 0.2}}, [](double) { return 0.1; });
    EXPECT_EQ(turns.at(0).x, 1.0);
    EXPECT_EQ(turns.at(0).y, 0.0);
    EXPECT_EQ(turns.at(4).x, 1.0);
    EXPECT_EQ(turns.at(5).y, -1.0) << "from north";
    EXPECT_EQ(turns.at(6).strength, 2.0);
    EXPECT_EQ(turns.at(7).x, 1.0) << "the first again";
    EXPECT_DOUBLE_EQ(turns.time(17), 1.7);
}

TEST(Dunes, GustsAreDrawnAboutTheWind) {
    DuneWind wind{270.0, 2.0, 10.0};
    wind.gust_angle = 10.0;
    wind.gust_strength = 0.3;
    wind.gust_duration = 0.2;
    const auto length = [](double) { return 0.1; };
    const WindSchedule turns({wind}, length, 5);
    double angle_squares = 0.0;
    double strength_squares = 0.0;
    double strength_sum = 0.0;
    constexpr int gusts = 4000;
    for (int gust = 0; gust < gusts; ++gust) {
        const BlowingWind first = turns.at(2 * gust);
        EXPECT_EQ(first.x, turns.at(2 * gust + 1).x) << "a gust lasts two steps";
        EXPECT_NEAR(std::hypot(first.x, first.y), 1.0, 1e-12);
        const double angle = std::atan2(first.y, first.x) * 180.0 / std::acos(-1.0);
        angle_squares += angle * angle;
        strength_sum += first.strength;
        strength_squares += (first.strength - 2.0) * (first.strength - 2.0);
    }
    EXPECT_NEAR(std::sqrt(angle_squares / gusts), 10.0, 0.5);
    EXPECT_NEAR(strength_sum / gusts, 2.0, 0.03);
    EXPECT_NEAR(std::sqrt(strength_squares / gusts), 0.6, 0.03);
    EXPECT_NE(turns.at(0).y, turns.at(2).y);
    EXPECT_NE(turns.at(0).y, WindSchedule({wind}, length, 6).at(0).y) << "another seed";
    wind.gust_angle = 0.0;
    wind.gust_strength = 0.0;
    EXPECT_EQ(WindSchedule({wind}, length, 5).at(7).x, 1.0);
}

/// A dune at the inflow feels nothing of one at the outflow, which would be right before it if the
/// bed went round.
TEST(Dunes, AcrossOpenEdgesNothingIsFelt) {
    WorkerPool pool(2);
    constexpr int n = 96;
    const auto bump = [](Grid& plane, double x0, double y0) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const double square = (x - x0) * (x - x0) + (y - y0) * (y - y0);
                plane(x, y) += 3.0 * std::exp(-square / 50.0);
            }
        }
    };
    for (const bool along_x : {true, false}) {
        const DuneGround ground{n, n, 1.0, 1.0, !along_x, along_x};
        const WindSchedule turns({{along_x ? 270.0 : 180.0, 1.0, 1.0}}, [](double) { return 1.0; });
        ReliefShear shear(ground, 3.5, 2.0, pool);
        Grid alone(n, n);
        bump(alone, along_x ? 8.0 : 48.0, along_x ? 48.0 : 8.0);
        Grid both = alone;
        bump(both, along_x ? 88.0 : 48.0, along_x ? 48.0 : 88.0);
        shear.apply(alone, turns.at(0));
        shear.apply(both, turns.at(0));
        double most = 0.0;
        double felt = 0.0;
        for (int y = 0; y < (along_x ? n : 20); ++y) {
            for (int x = 0; x < (along_x ? 20 : n); ++x) {
                most = std::max(most, std::abs(alone(x, y)));
                felt = std::max(felt, std::abs(both(x, y) - alone(x, y)));
            }
        }
        EXPECT_GT(most, 0.5);
        EXPECT_LT(felt, 0.02 * most) << "what is felt as far away in the open";
    }
}

/// Faces of avalanches are young, and ground that never slid as old as the run; in any transport.
TEST(Dunes, AgesAreSinceTheLastAvalanche) {
    WorkerPool pool(2);
    for (const Kind& kind : kinds()) {
        SCOPED_TRACE(kind.name);
        DunesParameters dunes = kind.parameters;
        dunes.avalanche_age = true;
        Grid bed(40, 40, 0.5);
        for (int y = 16; y < 24; ++y) {
            for (int x = 16; x < 24; ++x) bed(x, y) = 6.0;
        }
        Dunes model(dunes, setup(bed, pool));
        const auto age = [&] {
            const Snapshot now = model.snapshot();
            return std::ranges::find(now.fields, "avalanche_age", &SnapshotField::name)->values;
        };
        model.step();
        EXPECT_EQ(age()(23, 20), 0.0) << "its edge has come down";
        const bool even = dunes.transport == DuneTransport::continuous;  // slabs are steep steps
        if (even) {
            EXPECT_EQ(age()(3, 3), model.time()) << "far from it";
        }
        for (int step = 0; step < 3; ++step) model.step();
        if (even) {
            EXPECT_EQ(age()(3, 3), model.time());
        }
        const Grid ages = age();
        for (const double years : ages.values())
            EXPECT_TRUE(years >= 0.0 && years <= model.time()) << years;
    }
}

TEST(Dunes, RockMayBeTheBedOrALevel) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.rock = DuneRock::bed;
    dunes.sand_cover = 0.5;
    const Dunes covered(dunes, setup(Grid(20, 20, -3.0), pool));
    EXPECT_EQ(covered.bed().rock(3, 3), to_units(-3.0));
    EXPECT_EQ(covered.bed().surface(3, 3), to_units(-2.5));
    dunes.rock = DuneRock::level;
    EXPECT_NE(message_of<KeyError>([&] {
                  Dunes(dunes, setup(Grid(20, 20, -3.0), pool));
              }).find("below model.rock_level"),
              std::string::npos);
}

TEST(Dunes, WhatDoesNotFitIsRefused) {
    WorkerPool pool(1);
    const auto refusal = [&](const DunesParameters& dunes) {
        return message_of<KeyError>([&] { Dunes(dunes, setup(Grid(20, 20, 1.0), pool)); });
    };
    DunesParameters dunes;
    dunes.static_angle = 30.0;
    EXPECT_NE(refusal(dunes).find("model.static_angle is 30"), std::string::npos);
    dunes = {};
    dunes.shadow_soft_angle = 15.0;
    EXPECT_NE(refusal(dunes).find("smaller angle"), std::string::npos);
    dunes = {};
    dunes.transport = DuneTransport::slabs;
    EXPECT_NE(refusal(dunes).find("no shear stress"), std::string::npos);
    dunes.speed_up = DuneSpeedUp::none;
    dunes.order = SlabOrder::sequential;
    dunes.influx = 0.5;
    EXPECT_NE(refusal(dunes).find("hop in sequence"), std::string::npos);
    dunes = {};
    dunes.saturation_length = {"hops", 0.0};
    dunes.hop_length = 21.0;
    EXPECT_NE(refusal(dunes).find("exceed the box"), std::string::npos);
}

TEST(Dunes, TheCapOnPassesIsADoubt) {
    WorkerPool pool(1);
    DunesParameters dunes;
    dunes.avalanche_passes = 1;
    Grid bed(30, 30, 0.5);
    bed(15, 15) = 30.0;
    Dunes model(dunes, setup(std::move(bed), pool));
    model.step();
    EXPECT_NE(model.plausibility_warning().find("had not come to rest"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
