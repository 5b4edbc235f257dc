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

/// Drift potentials of a table, of a run under it, of a check, and of its winds by their speeds.
TEST(Orientation, ARunUnderATableHasItsDriftPotentials) {
    const ScratchFolder folder;
    write_text(folder / "rose.csv", "direction,speed\n270,8\n180,7\n");
    const std::string head =
        "[run]\nsteps = 2\n[grid]\nnx = 40\nny = 20\n[model]\nname = \"dunes\"\n";
    write_text(folder / "table.toml", head + "[[wind]]\ntable = \"rose.csv\"\n");
    write_text(folder / "winds.toml",
               head + "[[wind]]\nspeed = 8\n[[wind]]\nfrom = 180\nspeed = 7\n");
    const auto json_of = [&](std::vector<std::string> arguments) {
        arguments.emplace_back("--json");
        const Ended ended = fumon(arguments, folder.path());
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return nlohmann::json::parse(ended.output);
    };
    const auto table = json_of({"orientation", "--wind", "rose.csv"});
    const auto near = [&](const nlohmann::json& drift) {
        for (const char* name :
             {"drift_potential", "resultant_drift_potential", "resultant_drift_direction"}) {
            const double of_table = table[name].get<double>();
            EXPECT_NEAR(drift[name].get<double>() / of_table, 1.0, 1e-12) << name;
        }
    };
    for (const auto& checked : json_of({"check", "table.toml", "winds.toml"})) {
        near(checked["drift"]);
        EXPECT_NEAR(checked["drift"]["winds"][1]["flux"].get<double>(), 118.7018 / 2.0, 1e-3);
    }
    const Ended run = fumon({"run", "table.toml", "-o", "out", "--set", "output.frames=false",
                             "--set", "output.movie=false", "--set", "output.measure_every=1"},
                            folder.path());
    ASSERT_EQ(run.status, 0) << run.errors;
    near(read_manifest(folder / "out")["drift"]);
    EXPECT_NE(read_text(folder / "out/measurements.csv")
                  .find("drift_potential,resultant_drift_potential,rdp_dp,"
                        "resultant_drift_direction"),
              std::string::npos);
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
    write_text(folder / "friction.csv", "direction,friction_velocity\n270,0.4\n");
    write_text(folder / "flat.asc",
               "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n");
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"orientation"},
             {"orientation", "--wind", "none.csv"},
             {"orientation", "--wind", "bad.csv"},
             {"orientation", "--wind", "rose.csv", "--law", "bagnold"},
             {"orientation", "--wind", "rose.csv", "--roughness", "0"},
             {"orientation", "--wind", "rose.csv", "--roughness", "1", "--height", "1"},
             {"orientation", "--wind", "rose.csv", "--law", "fryberger", "--height", "2"},
             {"orientation", "--wind", "friction.csv", "--law", "fryberger"},
             {"orientation", "--wind", "rose.csv", "--bed", "flat.asc"}}) {
        const Ended ended = fumon(arguments, folder.path());
        EXPECT_EQ(ended.status, 2) << arguments.back();
        EXPECT_TRUE(ended.output.empty()) << ended.output;
        EXPECT_EQ(std::ranges::count(ended.errors, '\n'), 1) << ended.errors;
    }
}

}  // namespace
}  // namespace fumon::test
