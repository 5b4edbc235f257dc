#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "picture/png.h"
#include "run/picture_text.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A run with its frames and movie, and the same run with its beds alone; each test has folders of
/// its own beside them.
class RenderCommandTest : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<ScratchFolder>();
        write_text(*folder_ / "scene.toml", small_scene());
        ASSERT_EQ(run("scene.toml", "whole").status, 0);
        ASSERT_EQ(run("scene.toml", "beds", beds_alone()).status, 0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::vector<std::string> beds_alone() {
        return {"output.frames=false", "output.movie=false"};
    }

    static Ended run(const std::string& scene, const std::string& output,
                     const std::vector<std::string>& settings = {}) {
        std::vector<std::string> arguments{
            "run", scene, "-o", output, "--quiet", "--set", "output.fields_every=5"};
        for (const std::string& setting : settings)
            arguments.insert(arguments.end(), {"--set", setting});
        return fumon(arguments, folder_->path());
    }

    static Ended render(const std::string& output, const std::vector<std::string>& more = {},
                        const std::string& beds = "beds") {
        std::vector<std::string> arguments{"render", beds, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return fumon(arguments, folder_->path());
    }

    static void expect_the_runs_files(const std::string& output,
                                      const std::string& whole = "whole") {
        for (int frame = 0; frame < 5; ++frame) {
            const std::string name = "frames/frame_00000" + std::to_string(frame) + ".png";
            EXPECT_TRUE(read_text(*folder_ / output / name) == read_text(*folder_ / whole / name))
                << output << " " << name;
        }
        EXPECT_TRUE(read_text(*folder_ / output / "movie.mp4") ==
                    read_text(*folder_ / whole / "movie.mp4"))
            << output;
    }

    static std::unique_ptr<ScratchFolder> folder_;
};

std::unique_ptr<ScratchFolder> RenderCommandTest::folder_;

TEST_F(RenderCommandTest, TheRunsFramesAndMovieForAnyNumberOfShards) {
    for (const int shards : {1, 2, 3, 7}) {
        const std::string output = "shards" + std::to_string(shards);
        for (int number = shards; number >= 1; --number) {
            const Ended ended =
                render(output, {"--shard", std::to_string(number) + "/" + std::to_string(shards)});
            ASSERT_EQ(ended.status, 0) << ended.errors;
        }
        const Ended merged = render(output, {"--merge"});
        EXPECT_EQ(merged.errors, "5 frames: " + output + "/movie.mp4\n");
        expect_the_runs_files(output);
    }
}

/// look.low and look.high as a frame's scene has them.
std::string colours_of(const fs::path& frame) {
    const std::string scene = read_origin(frame).scene;
    const LookSettings look = parse_scene(scene, frame.string(), "").view.look;
    const auto text = [](const WordOrReal& end) {
        return end.is_word() ? end.word : std::to_string(end.value);
    };
    return text(look.low) + " to " + text(look.high);
}

TEST_F(RenderCommandTest, AllFramesHaveOneRangeOfColours) {
    const std::vector<std::string> coloured{"look.colour_by=height", "overlay.0.kind=colour-bar",
                                            "image.width=320", "image.height=240"};
    std::vector<std::string> alone = coloured;
    for (const std::string& setting : beds_alone()) alone.push_back(setting);
    ASSERT_EQ(run("scene.toml", "coloured", coloured).status, 0);
    ASSERT_EQ(run("scene.toml", "coloured-beds", alone).status, 0);
    ASSERT_EQ(render("coloured-later", {}, "coloured-beds").status, 0);
    const auto frame = [&](const std::string& folder, int number) {
        return *folder_ / folder / ("frames/frame_00000" + std::to_string(number) + ".png");
    };
    const std::string first = colours_of(frame("coloured", 0));
    const std::string all = colours_of(frame("coloured-later", 0));
    EXPECT_EQ(first.find("auto"), std::string::npos);
    EXPECT_EQ(all.find("auto"), std::string::npos);
    EXPECT_NE(first, all) << "of the first frame, and of all";
    for (int number = 1; number < 5; ++number) {
        EXPECT_EQ(colours_of(frame("coloured", number)), first);
        EXPECT_EQ(colours_of(frame("coloured-later", number)), all);
    }
    for (const char* folder : {"coloured", "coloured-later"}) {
        const Ended again =
            fumon({"again", frame(folder, 4).string(), "-o", "again.png"}, folder_->path());
        EXPECT_NE(again.errors.find("the same pixels"), std::string::npos) << again.errors;
    }
    std::vector<std::string> each = coloured;
    each.emplace_back("look.range=frame");
    ASSERT_EQ(run("scene.toml", "coloured-each", each).status, 0);
    EXPECT_EQ(colours_of(frame("coloured-each", 4)), "auto to auto");
}

TEST_F(RenderCommandTest, UnderMpirunTheLastProgramMakesTheMovie) {
    for (const char* rank : {"1", "0"}) {
        EXPECT_FALSE(fs::exists(*folder_ / "ranks/movie.mp4"));
        const Ended ended =
            fumon({"render", "beds", "-o", "ranks"}, folder_->path(),
                  {std::string("OMPI_COMM_WORLD_RANK=") + rank, "OMPI_COMM_WORLD_SIZE=2"});
        ASSERT_EQ(ended.status, 0) << ended.errors;
    }
    expect_the_runs_files("ranks");
    EXPECT_FALSE(fs::exists(*folder_ / "ranks/movie.mp4.lock"));
}

TEST_F(RenderCommandTest, PlotsOverTheFramesAndWaterInRain) {
    write_text(
        *folder_ / "water.toml",
        "seed = 3\n[model]\nname = \"gully\"\nslope = 0\nrain = 80\ninitial_water = "
        "\"film\"\ndepth = 0.2\n[camera]\nat = [12, 1, 1.2]\nlook_at = [12, 3, 0]\n[grid]\nnx = "
        "24\nny = 20\n[run]\nsteps = 20\n[frames]\nevery = 5\n[image]\nwidth = 240\nheight = "
        "180\n[[overlay]]\nkind = "
        "\"plot\"\ny = \"mean_height\"\n[[overlay]]\nkind = \"time\"\n");
    const Ended whole = run("water.toml", "water");
    ASSERT_EQ(whole.status, 0) << whole.errors;
    ASSERT_EQ(run("water.toml", "water-beds", beds_alone()).status, 0);
    ASSERT_EQ(render("water-frames", {}, "water-beds").status, 0);
    ASSERT_EQ(render("water-frames", {"--merge"}, "water-beds").status, 0);
    expect_the_runs_files("water-frames", "water");
}

TEST_F(RenderCommandTest, AKilledShardIsDoneAgainAndMissingFramesAreNamed) {
    ASSERT_EQ(render("killed", {"--frames", "0:1", "-q"}).status, 0);
    ASSERT_EQ(render("killed", {"--frames", "3", "-q"}).status, 0);
    write_text(*folder_ / "killed/frames/frame_000002.png.part",
               "half of a pictu");  // it was killed
    write_text(*folder_ / "killed/frames/frame_000002.png.lock", "");
    const Ended early = render("killed", {"--merge"});
    EXPECT_EQ(early.status, 3);
    EXPECT_EQ(
        early.errors,
        "killed: 2 of 5 frames are missing, so the movie is not made: 2, 4; `fumon render beds -o "
        "killed` draws the missing ones\n");
    EXPECT_FALSE(fs::exists(*folder_ / "killed/movie.mp4"));
    const Ended again = render("killed");
    EXPECT_EQ(again.errors, "5 of 5 frames are done (3 were there already): killed\n");
    ASSERT_EQ(render("killed", {"--merge", "-q"}).status, 0);
    expect_the_runs_files("killed");
    EXPECT_EQ(std::distance(fs::directory_iterator(*folder_ / "killed/frames"), {}), 5)
        << "nothing else is left";
}

TEST_F(RenderCommandTest, ProgramsBesideOneAnotherDrawEachFrameOnce) {
    std::vector<std::unique_ptr<Program>> programs;
    for (int n = 0; n < 3; ++n) {
        programs.push_back(std::make_unique<Program>(
            std::vector<std::string>{"render", "beds", "-o", "beside"}, folder_->path()));
    }
    for (const auto& program : programs) {
        const Ended ended = program->wait();
        EXPECT_EQ(ended.status, 0) << ended.errors;
    }
    ASSERT_EQ(render("beside", {"--merge", "-q"}).status, 0);
    expect_the_runs_files("beside");
}

TEST_F(RenderCommandTest, AnotherLookIsDrawnFromTheSameBeds) {
    const std::vector<std::string> turned{"--set", "camera.azimuth=200"};
    ASSERT_EQ(run("scene.toml", "turned", {"camera.azimuth=200"}).status, 0);
    ASSERT_EQ(render("look", turned).status, 0);
    ASSERT_EQ(render("look", {"--set", "camera.azimuth=200", "--merge"}).status, 0);
    expect_the_runs_files("look", "turned");
    const Ended other = render("look", {"--merge"});
    EXPECT_EQ(other.status, 3) << "they look otherwise";
    EXPECT_NE(other.errors.find("5 of 5 frames are missing"), std::string::npos) << other.errors;
    const Ended refused = render("new", {"--set", "model.creep_rate=0.3"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("model.creep_rate"), std::string::npos) << refused.errors;
    EXPECT_FALSE(fs::exists(*folder_ / "new"));
}

TEST_F(RenderCommandTest, AStillOfAStoredStepIsThatOfTheScene) {
    ASSERT_EQ(fumon({"still", "scene.toml", "--step", "10", "-o", "computed.png"}, folder_->path())
                  .status,
              0);
    ASSERT_EQ(fumon({"still", "beds", "--step", "10", "-o", "stored.png"}, folder_->path()).status,
              0);
    EXPECT_EQ(read_png(*folder_ / "stored.png"), read_png(*folder_ / "computed.png"));
    ASSERT_EQ(fumon({"still", "beds/fields.nc", "--step", "20", "-o", "last.png"}, folder_->path())
                  .status,
              0);
    ASSERT_EQ(fumon({"still", "beds", "-o", "end.png"}, folder_->path()).status, 0);
    EXPECT_EQ(read_text(*folder_ / "end.png"), read_text(*folder_ / "last.png"));
    EXPECT_NE(read_text(*folder_ / "end.png"), read_text(*folder_ / "stored.png"));
    const Ended between = fumon({"still", "beds", "--step", "12", "-o", "no.png"}, folder_->path());
    EXPECT_EQ(between.status, 2);
    EXPECT_EQ(between.errors,
              "beds: stored no bed of step 12, the nearest are of 10 and 15; take one of those, or "
              "draw the scene (fumon still SCENE --step 12), which computes the step\n");
    EXPECT_FALSE(fs::exists(*folder_ / "no.png"));
}

TEST_F(RenderCommandTest, WhatDoesNotFitIsRefused) {
    const auto refused = [&](const std::vector<std::string>& more, const std::string& line) {
        const Ended ended = render("new", more);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, line + "\n");
        EXPECT_FALSE(fs::exists(*folder_ / "new"));
    };
    refused(
        {"--frames", "3:5"},
        "--frames is \"3:5\"; it takes first:last, as 0:4, or one number: the run has the frames "
        "0 to 4");
    refused({"--set", "frames.every=3"},
            "--set: its scene has frames.every = 5, now 3; with stored beds only keys of the look "
            "and of the output files can change");
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "coarse", "-q", "--set", "output.fields_every=10",
                     "--set", "output.frames=false", "--set", "output.movie=false"},
                    folder_->path())
                  .status,
              0);
    EXPECT_EQ(fumon({"render", "coarse", "-o", "new"}, folder_->path()).errors,
              "frame 1 shows step 5, but the run stored no bed of that step; run the scene again "
              "with --set output.fields_every=N, where N divides 5\n");
    EXPECT_EQ(fumon({"render", "coarse", "-o", "new", "--frames", "2"}, folder_->path()).status, 0);
    fs::create_directories(*folder_ / "mine/frames");
    write_text(*folder_ / "mine/frames/frame_000001.png", "mine");
    const Ended mine = render("mine");
    EXPECT_EQ(mine.status, 2) << mine.errors;
    EXPECT_EQ(read_text(*folder_ / "mine/frames/frame_000001.png"), "mine");
    const Ended script = render("new2", {"--slurm", "4"});
    EXPECT_NE(script.output.find("command=( render beds -o new2 )"), std::string::npos)
        << script.output;
}

}  // namespace
}  // namespace fumon::test
