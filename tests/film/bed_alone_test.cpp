#include "film/beds/bed_alone.h"

#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace fumon::test {
namespace {

constexpr const char* rock_in_sand = R"(
[model]
name = "dunes"
transport = "continuous"
[[wind]]
from = 270
[[feature]]
kind = "rock"
x = 12
y = 10
length = 12
height = 3
[[feature]]
kind = "sand"
x = 6
y = 10
length = 8
height = 2
[grid]
nx = 24
ny = 20
[bed]
kind = "noise"
high = 0.02
[run]
steps = 40
[frames]
every = 40
[look]
mark = "ground"
ground = "table"
[image]
width = 64
height = 48
supersampling = 1
[output]
bed_every = 40
movie = false
)";

TEST(BedAlone, RockIsDrawnWhereNoSandLiesOnItNow) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", rock_in_sand);
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "run", "--quiet"}, folder.path()).errors, "");
    ASSERT_EQ(fumon({"render", "run", "-o", "drawn", "--quiet"}, folder.path()).errors, "");
    for (const char* name : {"frames/frame_000000.png", "frames/frame_000001.png"})
        EXPECT_TRUE(read_text(folder / "run" / name) == read_text(folder / "drawn" / name)) << name;
}

TEST(BedAlone, SaysWhatItDoesNotTell) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", rock_in_sand);
    const auto refusal = [&](const std::string& setting) {
        fumon({"run", "scene.toml", "-o", "run", "--force", "--quiet", "--set",
               "output.frames=false", "--set", "run.steps=1", "--set", setting},
              folder.path());
        return fumon({"render", "run", "-o", "drawn"}, folder.path()).errors;
    };
    const std::string rest = "; run the scene again with --set output.fields_every=N\n";
    EXPECT_EQ(refusal("model.rock_wear=0.01"),
              "run: its run stored beds without their worn rock" + rest);
    EXPECT_EQ(refusal("model.plants=grow"), "run: its run stored beds without their plants" + rest);
    EXPECT_FALSE(std::filesystem::exists(folder / "drawn"));
}

TEST(BedAlone, KeepsTheSandOnRockAndNothingElse) {
    Snapshot snapshot;
    snapshot.bed = Grid(2, 1, 5.0);
    snapshot.fields = {{"sand", "", "m", Grid(2, 1, 1.0)},
                       {"rock", "", "m", Grid(2, 1, 3.0)},
                       {"moving_sand", "", "m", Grid(2, 1, 1.0)}};
    snapshot.numbers = {{"sand_volume", "m3", 2.0}};
    keep_fields_of_bed(snapshot);
    ASSERT_EQ(snapshot.fields.size(), 2U);
    EXPECT_EQ(snapshot.fields[0].values(1, 0), 2.0);
    EXPECT_EQ(snapshot.fields[1].values(1, 0), 3.0);
    EXPECT_TRUE(snapshot.numbers.empty());
}

}  // namespace
}  // namespace fumon::test
