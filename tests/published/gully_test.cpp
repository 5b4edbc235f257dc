// Gullies (Saeki & Okamura 2007) against the numbers of independent programs for the same reading:
// transport as printed, cells of 1 m, noise of 0.01 m, steps of 0.1 s. Tolerances are those stated
// with the numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>

#include "base/error.h"
#include "measure/water/channels.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

/// Mean number of channels at each time, over seeds.
std::map<int, double> mean_channels(const GullyParameters& gully, int side, int seeds,
                                    const std::vector<int>& times) {
    std::vector<std::map<int, int>> counts(static_cast<std::size_t>(seeds));
    WorkerPool pool(2);
    pool.for_ranges(seeds, [&](int begin, int end) {
        for (int seed = begin; seed < end; ++seed) {
            GullyRun run(gully, noise(side, side, 0.01, static_cast<std::uint64_t>(seed) + 1), 1);
            for (const int time : times) {
                run.to(time);
                counts[static_cast<std::size_t>(seed)][time] =
                    static_cast<int>(find_channels(run.field("water_depth"), {}, 1.0, true).count);
            }
            EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
        }
    });
    std::map<int, double> means;
    for (const int time : times) {
        for (auto& of_seed : counts) means[time] += static_cast<double>(of_seed[time]) / seeds;
    }
    for (const auto& [time, mean] : means)
        std::printf("    slope %g, %d x %d, t = %d: %.2f channels\n", gully.slope.value, side, side,
                    time, mean);
    return means;
}

TEST(PublishedGully, ChannelsMergeOnTheFiguresSlope) {
    const auto means = mean_channels(as_printed(0.04), 100, 5, {100, 500, 1000});
    EXPECT_NEAR(means.at(100), 2.8, 0.8);
    EXPECT_NEAR(means.at(500), 2.4, 0.8);
    EXPECT_NEAR(means.at(1000), 1.4, 0.8);
}

TEST(PublishedGully, FiniteVolumesSpaceChannelsAlike) {
    GullyParameters gully = as_printed(0.04);
    gully.scheme = WaterScheme::finite_volume;
    const auto channels = mean_channels(gully, 100, 5, {100, 500});
    EXPECT_NEAR(channels.at(100), 2.8, 0.8);
    EXPECT_NEAR(channels.at(500), 2.4, 0.8);
}

TEST(PublishedGully, AGentleSlopeSoonHasOneChannel) {
    const auto means = mean_channels(as_printed(0.005), 100, 5, {100, 500});
    EXPECT_NEAR(means.at(100), 2.6, 0.8);
    EXPECT_NEAR(means.at(500), 1.0, 0.8);
}

TEST(PublishedGully, ALargerPlaneHasMoreChannels) {
    const auto means = mean_channels(as_printed(0.04), 200, 3, {100, 500, 1000});
    EXPECT_NEAR(means.at(100), 6.0, 1.5);
    EXPECT_NEAR(means.at(500), 4.0, 1.5);
    EXPECT_NEAR(means.at(1000), 3.0, 1.5);
}

// ---- a single channel ----

struct At {
    double time, floor;
};

/// Runs the trough of depth 0.02 and σ 4 and compares its floor; gives the last profile.
ChannelProfile single_channel(const GullyParameters& base, const std::array<At, 3>& expected,
                              double tolerance) {
    GullyParameters gully = base;
    gully.channel_depth = 0.02;
    gully.channel_width = 4.0;
    GullyRun run(gully, noise(100, 100, 0.002), 1);
    ChannelProfile profile;
    for (const At& at : expected) {
        run.to(at.time);
        profile = channel_profile(run.gully.snapshot().bed);
        std::printf("    slope %g, t = %g: floor %.4f, published %.4f, rim %.4f\n",
                    gully.slope.value, at.time, profile.floor, at.floor, profile.rim);
        EXPECT_NEAR(profile.floor, at.floor, tolerance * std::fabs(at.floor) + 5e-5) << at.time;
    }
    return profile;
}

TEST(PublishedGully, AChannelUnderAFilmFillsThenCutsDownAndRaisesRims) {
    const ChannelProfile last =
        single_channel(as_printed(), {{{100, -0.0073}, {300, -0.0087}, {600, -0.0194}}}, 0.03);
    EXPECT_NEAR(last.rim, 0.0028, 0.1 * 0.0028);
}

TEST(PublishedGully, AChannelUnderLevelWaterCutsDownAtOnce) {
    GullyParameters gully = as_printed();
    gully.initial_water = InitialWater::level;
    single_channel(gully, {{{100, -0.042}, {300, -0.088}, {600, -0.160}}}, 0.10);
}

TEST(PublishedGully, AChannelOnANearlyLevelPlaneOnlySpreads) {
    const ChannelProfile last =
        single_channel(as_printed(0.001), {{{100, -0.0054}, {300, -0.0023}, {600, -0.0007}}}, 0.03);
    EXPECT_LT(last.rim, 1e-4);
}

TEST(PublishedGully, ConservativeTransportFillsTheChannelAtEverySlope) {
    for (const double slope : {0.001, 0.04}) {
        GullyParameters gully = as_printed(slope);
        gully.transport = SedimentTransport::conservative;
        const ChannelProfile last =
            single_channel(gully, {{{100, -0.0054}, {300, -0.0023}, {600, -0.0007}}}, 0.03);
        EXPECT_LT(last.rim, 1e-4);
    }
}

// ---- the steep slope ----

TEST(PublishedGully, TheSteepSlopeNeverSettlesAndKeepsItsWater) {
    GullyRun run(as_printed(0.1), noise(100, 100, 0.01), 1);
    try {
        run.to(1000.0);
    } catch (const Error& error) {
        const std::string line = error.what();
        std::printf("    stopped: %s\n", line.c_str());
        EXPECT_NE(line.find("m/s at cell ("), std::string::npos);
        EXPECT_GT(run.gully.time(), 500.0) << "the roll waves of the first minutes are survived";
        return;
    }
    const Grid depth = run.field("water_depth");
    EXPECT_GE(*std::min_element(depth.values().begin(), depth.values().end()), 0.0);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
    EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12);
    const double before = channel_profile(run.gully.snapshot().bed).floor;
    std::printf("    floor %.3f at t = 1000\n", before);
    EXPECT_LT(before, -0.1) << "still cutting down";
}

}  // namespace
}  // namespace fumon::test
