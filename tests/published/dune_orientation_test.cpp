// Which way dunes lie under two winds, against what theory predicts with the model's own flux
// ratio: crests of a bed all of sand, and the dune that grows out of a source on bare rock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/crest_orientation.h"
#include "models/dunes/dunes.h"
#include "models/dunes/transport/saturation_hops.h"
#include "wind/crest_directions.h"

namespace fumon::test {
namespace {

Grid heights_in_metres(const DuneBed& bed) {
    Grid grid(bed.surface.nx(), bed.surface.ny());
    std::ranges::transform(bed.surface.values(), grid.values().begin(), to_metres);
    return grid;
}

/// How much more sand moves over the model's own ridge across the wind than over flat ground.
double flux_ratio_of_ridges() {
    constexpr double step = 0.001;
    DunesParameters parameters;
    parameters.time_step = {"", step};
    WorkerPool pool;
    Grid first(128, 24);
    for (int y = 0; y < 24; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : first.row(y)) height = 2.5 + stream.uniform();
    }
    Dunes dunes(parameters, {std::move(first), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    for (int n = 0; n < 1500; ++n) dunes.step();
    const Grid ridges = heights_in_metres(dunes.bed());
    const BedStatistics heights = bed_statistics(ridges, {});
    const SaturationHops hops =
        saturation_hops(parameters, {128, 24, 1.0, 1.0, true, true}, 1.0, 0.0);
    const double over_flat = parameters.flux * step * hops.kept / hops.length;
    double sum = 0.0;
    double crests = 0.0;
    for (int y = 0; y < ridges.ny(); ++y) {
        for (int x = 0; x < ridges.nx(); ++x) {
            if (ridges(x, y) < heights.mean + 0.8 * heights.standard_deviation) continue;
            bool is_crest = true;
            for (int k = 1; k <= 6; ++k) {
                is_crest = is_crest && ridges(x, y) >= ridges((x + k) % 128, y) &&
                           ridges(x, y) > ridges((x + 128 - k) % 128, y);
            }
            if (!is_crest) continue;
            sum += to_metres(dunes.bed().moving(x, y)) / over_flat;
            crests += 1.0;
        }
    }
    return sum / crests - 1.0;
}

/// Of two winds whose sand parts by an angle, the stronger one toward +x, the direction of the
/// crests, degrees counterclockwise from +x.
double crests_under(double ratio, double apart, std::uint64_t seed) {
    DunesParameters parameters;
    parameters.time_step = {"", 0.001};
    parameters.winds = {{270.0, 1.0, 0.04 * ratio}, {270.0 - apart, 1.0, 0.04}};
    WorkerPool pool;
    Grid first(128, 128);
    for (int y = 0; y < 128; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : first.row(y)) height = 2.5 + stream.uniform();
    }
    Dunes dunes(parameters, {std::move(first), {}, {1.0, 1.0, 1.0, true}, seed, pool});
    for (int n = 0; n < 1000; ++n) dunes.step();
    return std::fmod(crest_orientation(heights_in_metres(dunes.bed()), true).degrees + 270.0,
                     180.0);
}

TEST(PublishedDunes, CrestsOfTwoWindsRunAsTheoryHasIt) {
    const double ratio = flux_ratio_of_ridges();
    std::printf("    gamma %.2f\n", ratio);
    EXPECT_GT(ratio, 0.8);
    EXPECT_LT(ratio, 2.0);
    for (const auto& [strength, apart] :
         {std::pair{1.0, 60.0}, std::pair{2.0, 120.0}, std::pair{1.0, 150.0}}) {
        const CrestDirections theory =
            crest_directions(std::vector<SandFlux>{{0.0, strength}, {apart, 1.0}}, ratio);
        double mean = 0.0;
        for (const std::uint64_t seed : {1U, 2U}) mean += 0.5 * crests_under(strength, apart, seed);
        std::printf("    ratio %.0f, %3.0f degrees apart: %.1f measured, %.1f predicted\n",
                    strength, apart, mean, theory.bed_instability.at(0));
        EXPECT_NEAR(mean, theory.bed_instability.at(0), 5.0);
    }
}

/// As crests_under(), of 6 m of sand after four years, when slip faces hold a fifth of the bed.
double grown_crests_under(double ratio, double apart, const DunesParameters& flow) {
    constexpr int side = 192;
    DunesParameters parameters = flow;
    parameters.saturation_length = {"", 1.0};
    parameters.time_step = {"", 0.0008};
    parameters.winds = {{270.0, 1.0, 0.04 * ratio}, {270.0 - apart, 1.0, 0.04}};
    WorkerPool pool;
    Grid first(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : first.row(y)) height = 5.5 + stream.uniform();
    }
    Dunes dunes(parameters, {std::move(first), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    while (dunes.time() < 4.0) dunes.step();
    return std::fmod(crest_orientation(heights_in_metres(dunes.bed()), true).degrees + 270.0,
                     180.0);
}

/// The linear stress over slip faces that meet the next wind is too large, and the weaker wind
/// meets more of them: part of the cause. What is right is theory's direction (Gao et al. 2015 find
/// grown fields on it); without windward bubbles crests leave it by 10 degrees in four years. They
/// go on turning slowly with them.
TEST(PublishedDunes, GrownCrestsLeaveTheoryLessWithWindwardBubblesAndABentWind) {
    const CrestDirections theory =
        crest_directions(std::vector<SandFlux>{{0.0, 2.0}, {120.0, 1.0}}, 1.6);
    DunesParameters flow;
    const double plain = grown_crests_under(2.0, 120.0, flow);
    flow.windward_angle = {"", 16.7};
    const double with_bubbles = grown_crests_under(2.0, 120.0, flow);
    flow.wind_bend = DuneBend::shear;
    const double with_both = grown_crests_under(2.0, 120.0, flow);
    std::printf(
        "    four years, ratio 2, 120 degrees apart: %.1f, %.1f with bubbles, %.1f with a "
        "bent wind too, %.1f predicted\n",
        plain, with_bubbles, with_both, theory.bed_instability.at(0));
    EXPECT_LT(plain, theory.bed_instability.at(0) - 5.0) << "better than the guide says";
    EXPECT_NEAR(with_bubbles, theory.bed_instability.at(0), 5.0);
    EXPECT_NEAR(with_both, theory.bed_instability.at(0), 5.0);
}

/// Of two winds, as in crests_under(), the direction from a source of sand on bare rock to the sand
/// that has gathered beyond it.
double finger_under(double ratio, double apart) {
    constexpr int side = 80;
    constexpr double cell = 2.0;
    constexpr double source_x = 50.0;
    constexpr double source_y = 60.0;
    DunesParameters parameters;
    parameters.slope_drift = 0.2;
    parameters.winds = {{270.0, 1.0, 0.04 * ratio}, {270.0 - apart, 1.0, 0.04}};
    parameters.edges_x = DuneEdge::open;
    parameters.edges_y = DuneEdge::open;
    parameters.features = {
        {FeatureKind::source, FeatureShape::cone, source_x, source_y, 30.0, 30.0, 6.0, 90.0}};
    WorkerPool pool;
    Dunes dunes(parameters, {Grid(side, side), {}, {cell, cell, 1.0, true}, 1, pool});
    for (int step = 0; step < 1500; ++step) dunes.step();
    const Grid bed = heights_in_metres(dunes.bed());
    double east = 0.0;
    double north = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double dx = cell * (x + 0.5) - source_x;
            const double dy = cell * (y + 0.5) - source_y;
            constexpr double beyond = 20.0;  // m
            if (bed(x, y) < 0.5 || std::hypot(dx, dy) < beyond) continue;
            east += bed(x, y) * dx;
            north += bed(x, y) * dy;
        }
    }
    return std::atan2(north, east) * degrees_per_radian;
}

TEST(PublishedDunes, AFingerGrowsFromASourceWhereTheoryHasIt) {
    constexpr double flux_ratio = 1.35;  // of the model's ridges, see above
    for (const auto& [strength, apart] : {std::pair{1.0, 120.0}, std::pair{1.0, 150.0},
                                          std::pair{2.0, 120.0}, std::pair{2.0, 150.0}}) {
        const CrestDirections theory =
            crest_directions(std::vector<SandFlux>{{0.0, strength}, {apart, 1.0}}, flux_ratio);
        const double measured = finger_under(strength, apart);
        std::printf("    finger, ratio %.0f, %3.0f degrees apart: %.1f measured, %.1f predicted\n",
                    strength, apart, measured, theory.fingering.at(0));
        EXPECT_NEAR(measured, theory.fingering.at(0), 7.0);
    }
}

}  // namespace
}  // namespace fumon::test
