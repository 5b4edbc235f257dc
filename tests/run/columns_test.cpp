#include <gtest/gtest.h>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// Runs of the small scene without pictures.
class ColumnsTest : public ::testing::Test {
  protected:
    Ended run(const std::string& output, const std::vector<std::string>& settings) {
        write_text(folder_ / "scene.toml", small_scene() + overlay_);
        std::vector<std::string> arguments{
            "run",   "scene.toml",        "-o", output, "-q", "--set", "output.frames=false",
            "--set", "output.movie=false"};
        for (const std::string& setting : settings) {
            arguments.emplace_back("--set");
            arguments.push_back(setting);
        }
        return fumon(arguments, folder_.path());
    }

    std::string header(const std::string& output) {
        const std::string text = read_text(folder_ / output / "measurements.csv");
        return text.substr(0, text.find('\n'));
    }

    ScratchFolder folder_;
    std::string overlay_;
};

TEST_F(ColumnsTest, FewerColumnsAreOfTheSameModelRun) {
    ASSERT_EQ(run("all", {}).status, 0);
    const Ended some = run("some", {"output.columns=[\"slopes\", \"mean_height\"]"});
    ASSERT_EQ(some.status, 0) << some.errors;
    EXPECT_EQ(header("some"),
              "step,time,mean_height,stoss_slope,lee_slope,steep_stoss_slope,steep_lee_slope,"
              "stoss_to_lee_slope");
    const auto whole = read_manifest(folder_ / "all");
    const auto fewer = read_manifest(folder_ / "some");
    EXPECT_EQ(whole["state_sha256"], fewer["state_sha256"]);
}

TEST_F(ColumnsTest, WhatAPlotShowsIsAdded) {
    overlay_ = "[[overlay]]\nkind = \"plot\"\nx = \"time\"\ny = \"celerity\"\n";
    const Ended ended =
        run("plotted", {"output.columns=[\"mean_height\"]", "image.width=480", "image.height=270"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(header("plotted"), "step,time,mean_height,celerity");
}

TEST_F(ColumnsTest, AnUnknownNameIsRefusedWithTheNearestOneAndNothingIsWritten) {
    const Ended ended = run("out", {"output.columns=[\"mean_heigth\"]"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.errors.find("have no column or group of columns \"mean_heigth\"; did you mean "
                                "\"mean_height\"?"),
              std::string::npos)
        << ended.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace fumon::test
