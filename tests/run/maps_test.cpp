// Maps of rain, roughness and water from files, as a user's scene names them.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "files/hash.h"
#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr int map_columns = 24;
constexpr int map_rows = 16;

std::string grid_text(const std::string& place, double west, double east) {
    std::string text = "ncols 24\nnrows 16\n" + place + "cellsize 2\nNODATA_value -9999\n";
    for (int y = 0; y < map_rows; ++y) {
        for (int x = 0; x < map_columns; ++x)
            text += std::to_string(x < map_columns / 2 ? west : east) +
                    (x + 1 < map_columns ? " " : "\n");
    }
    return text;
}

class MapsTest : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directory(folder_ / "land");
        write_text(folder_ / "land/rain.asc", grid_text("", 200.0, 0.0));
        write_text(folder_ / "land/n.asc", grid_text("", 0.02, 0.09));
        write_text(folder_ / "land/scene.toml", scene());
    }

    static std::string scene(const std::string& more = "") {
        return R"(seed = 2
[model]
name = "water"
friction = "manning"
time_step = 1.0
[[map]]
quantity = "rain"
file = "rain.asc"
[[map]]
quantity = "roughness"
file = "n.asc"
)" + more + R"([grid]
nx = 24
ny = 16
cell_size = 2.0
[bed]
kind = "noise"
high = 0.2
[run]
steps = 12
[frames]
every = 12
[image]
width = 96
height = 64
[output]
movie = false
)";
    }

    [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }
    [[nodiscard]] std::string refusal(const std::string& text) const {
        write_text(folder_ / "land/scene.toml", text);
        const Ended ended = run({"run", "land/scene.toml", "-o", "bad", "-q"});
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "bad"));
        return ended.errors;
    }

    const ScratchFolder folder_{};
};

TEST_F(MapsTest, TheRunKnowsItsFilesAndAgainFindsThem) {
    const Ended first = run({"run", "land/scene.toml", "-o", "out", "-q"});
    ASSERT_EQ(first.status, 0) << first.errors;
    const auto manifest = nlohmann::json::parse(read_text(folder_ / "out/run.json"));
    ASSERT_EQ(manifest["inputs"].size(), 2U);
    EXPECT_EQ(manifest["inputs"][0]["path"], "land/rain.asc");
    EXPECT_EQ(manifest["inputs"][1]["sha256"], hex(file_hash(folder_ / "land/n.asc")));
    const fs::path frame = folder_ / "out/frames/frame_000001.png";
    ASSERT_TRUE(fs::exists(frame));

    const Ended again = run({"again", frame.string(), "-o", "again.png"});
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_NE(again.errors.find("the same pixels"), std::string::npos) << again.errors;

    write_text(folder_ / "land/rain.asc", grid_text("", 0.0, 200.0));
    const Ended changed = run({"again", frame.string(), "-o", "changed.png"});
    EXPECT_EQ(changed.status, 2);
    EXPECT_NE(changed.errors.find("land/rain.asc as it was"), std::string::npos) << changed.errors;
    const Ended other = run({"run", "land/scene.toml", "-o", "other", "-q"});
    ASSERT_EQ(other.status, 0) << other.errors;
    EXPECT_NE(nlohmann::json::parse(read_text(folder_ / "other/run.json"))["state_sha256"],
              manifest["state_sha256"]);
}

TEST_F(MapsTest, AStoppedRunGoesOnWithThem) {
    std::vector<std::string> arguments{
        "run",   "land/scene.toml",    "-o", "whole", "-q", "--set", "run.steps=1000",
        "--set", "output.frames=false"};
    ASSERT_EQ(run(arguments).status, 0);
    arguments[3] = "out";
    std::vector<std::string> often = arguments;
    often.insert(often.end(), {"--checkpoint-every", "0.00001"});
    Program program(often, folder_.path());
    for (int tries = 0; tries < 5000 && !fs::exists(folder_ / "out/checkpoint.fumon"); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(SIGINT);
    ASSERT_EQ(program.wait().status, 130);
    fs::copy(folder_ / "out", folder_ / "copy", fs::copy_options::recursive);
    const auto state = [&](const char* name) {
        return nlohmann::json::parse(read_text(folder_ / name / "run.json"))["state_sha256"];
    };
    const Ended alone = run({"run", "--resume", "out", "-q"});
    EXPECT_EQ(alone.status, 0) << alone.errors;
    EXPECT_EQ(state("out"), state("whole"));
    const Ended named = run({"run", "land/scene.toml", "--resume", "copy", "-q", "--set",
                             "run.steps=1000", "--set", "output.frames=false"});
    EXPECT_EQ(named.status, 0) << named.errors;
    EXPECT_EQ(state("copy"), state("whole"));
}

TEST_F(MapsTest, OneOfTheTimesOfANetcdfFile) {
    const Ended first = run({"run", "land/scene.toml", "-o", "out", "-q", "--set",
                             "output.fields_every=6", "--set", "output.frames=false"});
    ASSERT_EQ(first.status, 0) << first.errors;
    const std::string depth =
        "[[map]]\nquantity = \"depth\"\nfile = \"../out/fields.nc\"\nvariable = \"water_depth\"\n";
    const auto manifest_of = [&](const std::string& more) {
        write_text(folder_ / "land/scene.toml", scene(depth + more));
        const Ended ended = run({"run", "land/scene.toml", "-o", "next", "-q", "--force", "--set",
                                 "output.frames=false"});
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return nlohmann::json::parse(read_text(folder_ / "next/run.json"));
    };
    const auto last = manifest_of("");
    EXPECT_NE(last["note"].get<std::string>().find(
                  "map.2.file: the last of 3 records of water_depth is read"),
              std::string::npos);
    EXPECT_EQ(manifest_of("record = 3\n")["state_sha256"], last["state_sha256"]);
    EXPECT_FALSE(manifest_of("record = 3\n").contains("note"));
    EXPECT_NE(manifest_of("record = 2\n")["state_sha256"], last["state_sha256"]);
    EXPECT_NE(refusal(scene(depth + "record = 4\n"))
                  .find("water_depth has 3 records; name one of them by map.2.record, 1 to 3"),
              std::string::npos);
    const std::string rain =
        "[[map]]\nquantity = \"rain\"\nfrom = 5\nfile = \"../out/fields.nc\"\nvariable = "
        "\"water_depth\"\n";
    EXPECT_NE(refusal(scene(rain)).find("water_depth has 3 records; name one of them"),
              std::string::npos);
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\nfile = \"n.asc\"\nrecord = 1\n"))
                  .find("leave map.2.record out"),
              std::string::npos);
}

TEST_F(MapsTest, WhatIsWrongIsSaidAtItsKey) {
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\n"))
                  .find("map.2.file is missing; name the file that has the values"),
              std::string::npos);
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\nfile = \"no.asc\"\n"))
                  .find("scene.toml:14:8: map.2.file \"no.asc\" does not exist (looked for "
                        "land/no.asc)"),
              std::string::npos);
    write_text(folder_ / "land/small.asc",
               "ncols 2\nnrows 2\ncellsize 24\nNODATA_value -9999\n1 2\n3 4\n");
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\nfile = \"small.asc\"\n"))
                  .find("land/small.asc: has 2 x 2 cells, but the bed has 24 x 16"),
              std::string::npos);
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\nfile = \"n.asc\"\nvariable = \"h\"\n"))
                  .find("leave map.2.variable out"),
              std::string::npos);
    write_text(folder_ / "land/shades.png", "\x89PNG\r\n\x1a\n");
    EXPECT_NE(refusal(scene("[[map]]\nquantity = \"depth\"\nfile = \"shades.png\"\n"))
                  .find("land/shades.png: a PNG image holds shades, not numbers with a unit; give"),
              std::string::npos);
}

}  // namespace
}  // namespace fumon::test
