// The sandpile of Higashi & Takamori (2003) against the numbers of independent programs (means over
// five seeds), by sweeps. Tolerances are those stated with the numbers.

#include <gtest/gtest.h>

#include <cmath>

#include "measure/pile/avalanche_sizes.h"
#include "measure/pile/power_law.h"
#include "published/sweep_table.h"

namespace fumon::test {
namespace {

using Row = SweepTable::Row;

bool from_30000(const Row& row) {
    return row.at("step") >= 30000;
}

TEST(PublishedPile, OfSixteenCellsSaturates) {
    const SweepTable table({"figures/higashi-2003-12.toml", {}, {}});
    const double height = table.mean("maximum_height", from_30000);
    std::printf("    M = 16: largest height %.2f, published 19.17\n", height);
    EXPECT_NEAR(height, 19.17, 0.3);
    expect_within(table.mean("resident_grains", from_30000), 2076, 0.01, "M = 16: resident grains");
    for (const Row& row : table.rows())  // no grain is lost uncounted
        EXPECT_EQ(row.at("resident_grains") + row.at("lost_grains"), row.at("step"));
    // saturated from S ≈ 3000
    const double early =
        table.mean("resident_grains", [](const Row& row) { return row.at("step") == 3500; });
    EXPECT_NEAR(early, 2076, 0.05 * 2076);
    EXPECT_LT(table.mean("resident_grains", [](const Row& row) { return row.at("step") == 1000; }),
              1001);
}

/// The slope of log A_p over log A_s in 10 … 100, each run by itself; the mean over runs.
double mean_slope(const SweepTable& table) {
    double sum = 0.0;
    for (const auto& sizes : table.avalanche_sizes()) {
        AvalancheSizes counted;
        for (const long long size : sizes) counted.add(size);
        sum += fit_raw_bins(counted).slope;
    }
    return sum / static_cast<double>(table.avalanche_sizes().size());
}

TEST(PublishedPile, AvalanchesOfSixteenCellsFollowAPowerLaw) {
    const SweepTable table({"figures/higashi-2003-15.toml", {}, {}});
    const double slope = mean_slope(table);
    std::printf("    M = 16: slope of A_p over A_s in 10 … 100: %.3f, published -1.58\n", slope);
    EXPECT_NEAR(slope, -1.58, 0.12);
}

TEST(PublishedPile, OfSixtyFourCellsDependsOnTheOrder) {
    const SweepTable sweep({"figures/higashi-2003-19.toml", {"grid.nx+grid.ny=64"}, {}});
    const double height = sweep.mean("maximum_height", from_30000);
    std::printf("    M = 64: largest height %.2f, published 46.9\n", height);
    EXPECT_NEAR(height, 46.9, 0.8);
    expect_within(sweep.mean("resident_grains", from_30000), 36600, 0.03,
                  "M = 64, sweep order: resident grains");
    const double slope = mean_slope(sweep);
    std::printf("    M = 64: slope of A_p over A_s in 10 … 100: %.3f, published -1.48\n", slope);
    EXPECT_NEAR(slope, -1.48, 0.12);

    const SweepTable queue({"figures/higashi-2003-18.toml",
                            {"grid.nx+grid.ny=64"},
                            {"model.order=first-in-first-out"}});
    expect_within(queue.mean("resident_grains", from_30000), 37700, 0.03,
                  "M = 64, first in, first out: resident grains");
    EXPECT_GT(queue.mean("resident_grains", from_30000), sweep.mean("resident_grains", from_30000));
}

TEST(PublishedPile, TheCircularMeanCuresTheDrift) {
    const auto last = [](const Row& row) { return row.at("step") == 60000; };
    const SweepTable drifting({"figures/higashi-2003-18.toml", {"grid.nx+grid.ny=64"}, {}});
    const SweepTable upright({"figures/higashi-2003-18.toml",
                              {"grid.nx+grid.ny=64"},
                              {"model.direction=circular-mean"}});
    const double fit = drifting.mean("drop_cone_r_squared", last);
    const double cured = upright.mean("drop_cone_r_squared", last);
    std::printf(
        "    M = 64: cone fit R² %.2f, published about .2; circular mean %.3f, published .98\n",
        fit, cured);
    EXPECT_LT(fit, 0.45);
    EXPECT_GT(cured, 0.93);
    EXPECT_GT(upright.mean("cone_r_squared", last), 0.96);
    EXPECT_GT(drifting.mean("cone_offset", last), 5.0);  // "some ten cells"
    EXPECT_LT(upright.mean("cone_offset", last), 2.0);
}

}  // namespace
}  // namespace fumon::test
