#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/program.h"

namespace fumon::test {
namespace {

/// 40 x 40 cells of waves whose crests run along a direction, degrees clockwise from north.
std::string crests_along(double direction) {
    const double angle = direction * 3.141592653589793 / 180.0;
    std::string text = "ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int row = 0; row < 40; ++row) {
        for (int x = 0; x < 40; ++x) {
            const double across = x * std::cos(angle) - (39 - row) * std::sin(angle);
            text += std::to_string(std::sin(0.5 * across)) + (x < 39 ? " " : "\n");
        }
    }
    return text;
}

TEST(Orientation, IsPredictedAndMeasured) {
    const ScratchFolder folder;
    write_text(folder / "rose.csv", "direction,flux\n270,2\n150,1\n");  // toward 90 and 330
    write_text(folder / "bed.asc", crests_along(163.7));
    const Ended ended =
        fumon({"orientation", "--wind", "rose.csv", "--bed", "bed.asc", "--open", "--json"},
              folder.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    const auto json = nlohmann::json::parse(ended.output);
    EXPECT_NEAR(json["drift_potential"].get<double>(), 3.0, 1e-12);
    // 73.7 and 39.2 degrees from the stronger wind toward the other (Courrech du Pont et al. 2014)
    ASSERT_EQ(json["crests_by_bed_instability"].size(), 1U);
    EXPECT_NEAR(json["crests_by_bed_instability"][0].get<double>(), 90.0 - 73.7, 0.1);
    EXPECT_NEAR(json["growth_by_fingering"][0].get<double>(), 90.0 - 39.2, 0.1);
    EXPECT_NEAR(json["measured_crests"].get<double>(), 163.7, 0.5);
    EXPECT_GT(json["measured_coherence"].get<double>(), 0.9);

    const Ended text =
        fumon({"orientation", "--wind", "rose.csv", "--bed", "bed.asc", "--open"}, folder.path());
    EXPECT_EQ(text.status, 0) << text.errors;
    EXPECT_NE(text.output.find("16.3 degrees"), std::string::npos) << text.output;
    EXPECT_NE(text.output.find("away from bed instability        32."), std::string::npos)
        << text.output;
}

TEST(Orientation, TellsWhereNoneIsFavoured) {
    const ScratchFolder folder;
    write_text(folder / "calm.csv", "direction,speed\n270,2\n");
    const Ended ended = fumon({"orientation", "--wind", "calm.csv"}, folder.path());
    EXPECT_EQ(ended.status, 0);
    EXPECT_NE(ended.output.find("none favoured"), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("nowhere"), std::string::npos) << ended.output;
}

TEST(Orientation, RefusesInOneLine) {
    const ScratchFolder folder;
    write_text(folder / "rose.csv", "direction,speed\n270,2\n");
    write_text(folder / "bad.csv", "direction,speed\n270,fast\n");
    write_text(folder / "flat.asc",
               "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n");
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"orientation"},
             {"orientation", "--wind", "none.csv"},
             {"orientation", "--wind", "bad.csv"},
             {"orientation", "--wind", "rose.csv", "--law", "bagnold"},
             {"orientation", "--wind", "rose.csv", "--roughness", "0"},
             {"orientation", "--wind", "rose.csv", "--bed", "flat.asc"}}) {
        const Ended ended = fumon(arguments, folder.path());
        EXPECT_EQ(ended.status, 2) << arguments.back();
        EXPECT_TRUE(ended.output.empty()) << ended.output;
        EXPECT_EQ(std::ranges::count(ended.errors, '\n'), 1) << ended.errors;
    }
}

}  // namespace
}  // namespace fumon::test
