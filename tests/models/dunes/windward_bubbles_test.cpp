// Still air before slopes that face the wind more steeply than it follows them.

#include "models/dunes/wind/windward_bubbles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"

namespace fumon::test {
namespace {

constexpr double angle = 16.7;

double tangent(double degrees) {
    return std::tan(degrees * degree);
}

/// A ridge along y that rises at one angle toward its crest at x = 60 m and falls at another.
Grid ridge(double rise, double fall) {
    Grid bed(128, 24);
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double from_crest = x - 60.0;
            const double down =
                from_crest < 0.0 ? -from_crest * tangent(rise) : from_crest * tangent(fall);
            bed(x, y) = 1.0 + std::max(6.0 - down, 0.0);
        }
    }
    return bed;
}

/// The drift that the wind lifts over a bed, in parts of that over flat ground.
Grid lifted_over(Grid bed, double from, const WordOrReal& windward_angle) {
    DunesParameters parameters;
    parameters.winds = {{from, 1.0, 1.0}};
    parameters.windward_angle = windward_angle;
    WorkerPool pool(2);
    const Dunes dunes(parameters, {std::move(bed), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    return *field_of(dunes.snapshot().fields, "local_wind");
}

double largest_difference(const Grid& first, const Grid& second) {
    double largest = 0.0;
    for (std::size_t cell = 0; cell < first.size(); ++cell)
        largest = std::max(largest, std::abs(first.values()[cell] - second.values()[cell]));
    return largest;
}

TEST(WindwardBubbles, LieBeforeASlipFaceAlone) {
    WorkerPool pool(2);
    const DuneGround ground{128, 24, 1.0, 1.0, true, true};
    FixedPointGrid surface(128, 24);
    const Grid heights = ridge(33.0, 12.0);
    std::ranges::transform(heights.values(), surface.values().begin(), to_units);
    WindwardBubbles bubbles(ground, tangent(angle), pool);
    for (const bool meets_slip_face : {true, false}) {
        Grid relief = heights;
        bubbles.find(surface, {meets_slip_face ? 1.0 : -1.0, 0.0}).fill(relief);
        for (int x = 0; x < 128; ++x) {
            const double bubble = meets_slip_face && x < 60 ? 7.0 - (60 - x) * tangent(angle) : 0.0;
            EXPECT_NEAR(relief(x, 11), std::max(heights(x, 11), bubble), 1e-8) << x;
        }
    }
}

TEST(WindwardBubbles, ASlipFaceSpeedsTheWindUpNoMoreThanTheirSlope) {
    const WordOrReal told{"", angle};
    const auto at_crest = [](const Grid& lifted) { return lifted(60, 11); };
    const Grid gentle = lifted_over(ridge(angle, 12.0), 270.0, {"none", 0.0});
    const Grid steep = lifted_over(ridge(33.0, 12.0), 270.0, told);
    EXPECT_NEAR(largest_difference(gentle, steep), 0.0, 1e-6);
    EXPECT_GT(at_crest(lifted_over(ridge(33.0, 12.0), 270.0, {"none", 0.0})),
              1.15 * at_crest(steep));
}

TEST(WindwardBubbles, GentlerSlopesHaveNone) {
    for (const double from : {270.0, 90.0, 225.0}) {
        const Grid bed = ridge(16.0, 12.0);
        EXPECT_EQ(largest_difference(lifted_over(bed, from, {"", angle}),
                                     lifted_over(bed, from, {"none", 0.0})),
                  0.0)
            << from;
    }
}

TEST(WindwardBubbles, AreOfTheShearStressAlone) {
    WorkerPool pool(1);
    DunesParameters parameters;
    parameters.windward_angle = {"", angle};
    parameters.speed_up = DuneSpeedUp::none;
    try {
        const Dunes dunes(parameters, {Grid(20, 20, 1.0), {}, {1.0, 1.0, 1.0, true}, 7, pool});
        FAIL() << "nothing knows of bubbles";
    } catch (const KeyError& error) {
        EXPECT_NE(std::string(error.what()).find("model.windward_angle"), std::string::npos);
    }
}

}  // namespace
}  // namespace fumon::test
