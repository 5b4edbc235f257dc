// Gullies (Saeki & Okamura 2007) against the numbers of independent programs for the same reading:
// transport as printed, cells of 1 m, noise of 0.01 m, steps of 0.1 s. Tolerances are those stated
// with the numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "measure/water/channels.h"
#include "support/gully_run.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

/// Over how many seeds the channels are counted at a time.
struct Count {
    double time;
    int seeds;
};

/// The mean number of channels at each time. Later counts take no more seeds than earlier ones.
std::map<double, double> mean_channels(const GullyParameters& gully, int side,
                                       const std::vector<Count>& counts) {
    constexpr int threads = 2;
    const int seeds = counts.front().seeds;
    std::vector<std::vector<double>> channels(static_cast<std::size_t>(seeds));
    WorkerPool pool(threads);
    pool.for_ranges(threads, [&](int begin, int end) {
        for (int first = begin; first < end; ++first) {
            for (int seed = first; seed < seeds; seed += threads) {
                const auto of_seed = static_cast<std::size_t>(seed);
                GullyRun run(gully, noise(side, side, 0.01, of_seed + 1), 1);
                for (const Count& count : counts) {
                    if (seed >= count.seeds) break;
                    run.to(count.time);
                    channels[of_seed].push_back(
                        find_channels(run.field("water_depth"), {}, 1.0, true).count);
                }
                EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
            }
        }
    });
    std::map<double, double> means;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        double& mean = means[counts[k].time];
        for (const auto& of_seed : channels) {
            if (k < of_seed.size()) mean += of_seed[k] / counts[k].seeds;
        }
        std::printf("    slope %g, %d x %d, t = %g: %.2f channels\n", gully.slope.value, side, side,
                    counts[k].time, mean);
    }
    return means;
}

/// Single counts scatter by 0.6 at t = 100, so 20 seeds know their mean to 0.14; the published
/// means are of five.
constexpr int many_seeds = 20;

TEST(PublishedGully, ChannelsMergeOnTheFiguresSlopeAndSoonerOnAGentleOne) {
    const auto steep =
        mean_channels(as_printed(0.04), 100, {{100, many_seeds}, {500, 5}, {1000, 5}});
    EXPECT_NEAR(steep.at(100), 2.8, 0.5);
    EXPECT_NEAR(steep.at(500), 2.4, 0.5);
    EXPECT_NEAR(steep.at(1000), 1.4, 0.5);
    const auto gentle = mean_channels(as_printed(0.005), 100, {{100, many_seeds}, {500, 5}});
    EXPECT_NEAR(gentle.at(100), 2.6, 0.5);
    EXPECT_NEAR(gentle.at(500), 1.0, 0.2);
    EXPECT_GT(steep.at(100), gentle.at(100) + 0.4) << "twice the error of the difference";
}

TEST(PublishedGully, FiniteVolumesSpaceChannelsAlike) {
    GullyParameters gully = as_printed(0.04);
    gully.scheme = WaterScheme::finite_volume;
    const auto channels = mean_channels(gully, 100, {{100, 10}, {500, 2}});
    EXPECT_NEAR(channels.at(100), 2.8, 0.5);
    EXPECT_NEAR(channels.at(500), 2.4, 0.5);
}

TEST(PublishedGully, ALargerPlaneHasMoreChannels) {
    const auto means = mean_channels(as_printed(0.04), 200, {{100, 3}, {500, 3}, {1000, 3}});
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
    single_channel(gully, {{{100, -0.042}, {300, -0.088}, {600, -0.160}}}, 0.03);
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

/// As printed it never settles: it cuts down until its water runs away, which is one line that says
/// where, when and what to do. No machine runs on to t = 1000 (tests/README.md, the final state).
TEST(PublishedGully, TheSteepSlopeCutsDownUntilTheRunStopsWithOneLine) {
    GullyRun run(as_printed(0.1), noise(100, 100, 0.01), 1);
    double floor = 0.0;
    for (const double time : {200.0, 400.0, 600.0}) {
        run.to(time);
        EXPECT_GE(run.lowest_depth(), 0.0) << time;
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12) << time;
        EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12) << time;
        const double before = std::exchange(floor, channel_profile(run.gully.snapshot().bed).floor);
        std::printf("    slope 0.1, t = %g: floor %.4f\n", time, floor);
        EXPECT_LT(floor, before - 0.05) << time;
    }
    const std::string line = message_of<Error>([&] { run.to(1000.0); });
    std::printf("    stopped: %s\n", line.c_str());
    EXPECT_TRUE(line.starts_with("the speed became ")) << line;
    EXPECT_NE(line.find(" m/s at cell ("), std::string::npos) << line;
    EXPECT_NE(line.find(", t = 885.471 s, "), std::string::npos) << line;
    EXPECT_TRUE(
        line.ends_with("; try a smaller model.transport_factor or model.time_step, more "
                       "model.friction_coefficient or model.bed_diffusion"))
        << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
