#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "files/file_lock.h"
#include "files/folder_lock.h"
#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// The runs that figures are made from, stored beside them.
class FigureRunsTest : public FigureTest {};

TEST_F(FigureRunsTest, TheSecondTimeNothingIsSimulatedAndTheBytesAreTheSame) {
    write_scene("plots.toml", curves);
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("plots.toml", {"pictures.toml"}).status, 0);
    std::vector<fs::file_time_type> times;
    for (const std::string& run : runs())
        times.push_back(fs::last_write_time(folder_ / "out/runs" / run));
    const Ended again = figure("plots.toml", {"pictures.toml", "--runs", "out/runs"}, "second");
    ASSERT_EQ(again.status, 0) << again.errors;
    std::size_t k = 0;
    for (const std::string& run : runs())
        EXPECT_EQ(fs::last_write_time(folder_ / "out/runs" / run), times[k++]);
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory()) continue;
        EXPECT_EQ(text("second/" + name), text("out/" + name)) << name;
    }
}

TEST_F(FigureRunsTest, FilesOfOthersInAStoredRunStopItFromBeingMadeAnew) {
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("pictures.toml").status, 0);
    const std::string notes = "out/runs/" + runs()[0] + "/notes.txt";
    write_text(folder_ / notes, "mine");
    write_scene("pictures.toml", pictures + "[[figure.panel]]\nkind = \"map\"\nsteps = [7]\n");
    const Ended ended = figure("pictures.toml");
    EXPECT_NE(ended.status, 0);
    EXPECT_NE(ended.errors.find(notes + ": is not a file of a stored run"), std::string::npos)
        << ended.errors;
    EXPECT_EQ(text(notes), "mine");
    fs::remove(folder_ / notes);
    EXPECT_EQ(figure("pictures.toml").status, 0);
}

TEST_F(FigureRunsTest, OneRunServesAllStepsOfAllPanels) {
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("pictures.toml").status, 0);
    ASSERT_EQ(runs().size(), 1U);
    const auto job = nlohmann::json::parse(text("out/runs/" + runs()[0] + "/job.json"));
    EXPECT_EQ(job["fields_at"], (std::vector<int>{0, 5, 20}));
    write_scene("more.toml", pictures + "[[figure.panel]]\nkind = \"map\"\nsteps = [7]\n");
    ASSERT_EQ(figure("more.toml").status, 0);
    ASSERT_EQ(runs().size(), 1U);
    const auto more = nlohmann::json::parse(text("out/runs/" + runs()[0] + "/job.json"));
    EXPECT_EQ(more["fields_at"], (std::vector<int>{0, 5, 7, 20}));
    EXPECT_EQ(more["state_sha256"], job["state_sha256"]);
    EXPECT_TRUE(fs::exists(folder_ / "out/more-c.asc"));
    EXPECT_TRUE(fs::exists(folder_ / "out/more-d.asc"));
    EXPECT_FALSE(fs::exists(folder_ / "out/more-e.asc"));
}

TEST_F(FigureRunsTest, WhatAFinishedRunsSnapshotsLookLikeIsKnownFromItsFolder) {
    write_scene("time.toml",
                "[figure]\nwidth = \"single\"\n[[figure.panel]]\n[[figure.panel.curve]]\nx = "
                "\"time\"\ny = \"mean_height\"\n[[figure.panel]]\n[[figure.panel.curve]]\ntable = "
                "\"profile\"\nx = \"x\"\ny = \"height\"\n");
    const auto first_columns = [&] {
        const Ended ended = figure("time.toml");
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return std::vector<std::string>{cells_of(text("out/time-a-1.csv"))[0][0],
                                        cells_of(text("out/time-b-1.csv"))[0][0]};
    };
    const auto own = first_columns();
    ASSERT_EQ(runs().size(), 1U);
    const std::string file = "out/runs/" + runs()[0] + "/job.json";
    const auto change = [&](const auto& changing) {
        auto job = nlohmann::ordered_json::parse(text(file));
        changing(job);
        write_text(folder_ / file, job.dump());
    };
    change([](auto& job) {
        job["snapshots"]["time_unit"] = "weeks";
        job["snapshots"]["scale"]["in_metres"] = !job["snapshots"]["scale"]["in_metres"];
    });
    const auto told = first_columns();
    EXPECT_EQ(told[0], "time (weeks)") << "a model would have said steps";
    EXPECT_NE(told[1], own[1]);
    const std::vector<void (*)(nlohmann::ordered_json&)> damages{
        [](nlohmann::ordered_json& job) { job.erase("snapshots"); },
        [](nlohmann::ordered_json& job) { job["snapshots"].erase("scale"); },
        [](nlohmann::ordered_json& job) { job["snapshots"]["fields"] = 3; },
        [](nlohmann::ordered_json& job) { job["snapshots"]["nx"] = 0; },
        [](nlohmann::ordered_json& job) { job["snapshots"]["ny"] = 1LL << 40; }};
    for (std::size_t k = 0; k < damages.size(); ++k) {
        change(damages[k]);
        EXPECT_EQ(first_columns(), own) << "damage " << k << ": the run is made again";
    }
}

TEST_F(FigureRunsTest, KilledOrInterruptedItGoesOn) {
    write_scene("plots.toml", curves);
    const std::vector<std::string> longer{"--set", "run.steps=1500", "--threads", "1"};
    std::vector<std::string> arguments{"figure", "plots.toml", "-o", "out"};
    arguments.insert(arguments.end(), longer.begin(), longer.end());
    for (const int signal : {SIGKILL, SIGINT}) {
        const auto finished = [&] {
            std::size_t count = 0;
            if (!fs::exists(folder_ / "out/runs")) return count;
            for (const std::string& name : runs()) count += name.size() == 16 ? 1U : 0U;
            return count;
        };
        const std::size_t before = finished();
        Program program(arguments, folder_.path());
        for (int tries = 0; tries < 3000 && finished() <= before; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.send(signal);
        const Ended ended = program.wait();
        EXPECT_EQ(ended.status, signal == SIGINT ? 130 : 128 + SIGKILL) << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "out/plots.pdf"));
        EXPECT_LT(finished(), 6U);
    }
    const Ended ended = figure("plots.toml", longer);
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("of 6 runs were there already"), std::string::npos);
    EXPECT_EQ(runs().size(), 6U) << "no locks, no parts";
    ASSERT_EQ(figure("plots.toml", longer, "fresh").status, 0);
    EXPECT_EQ(text("out/plots.svg"), text("fresh/plots.svg"));
}

TEST_F(FigureRunsTest, WhatAKillLeftBesideAStoredRunIsTakenAway) {
    write_scene("pictures.toml", pictures);
    ASSERT_EQ(figure("pictures.toml").status, 0);
    const fs::path run = folder_ / "out/runs" / runs()[0];
    const fs::path previous = run.string() + ".former";
    write_text(run.string() + ".lock", "");
    fs::copy(run, previous);
    write_text(previous / "notes.txt", "mine");
    ASSERT_EQ(figure("pictures.toml", {"--runs", "out/runs"}, "second").status, 0);
    EXPECT_EQ(runs().size(), 2U);
    EXPECT_EQ(text("out/runs/" + previous.filename().string() + "/notes.txt"), "mine");
    EXPECT_FALSE(fs::exists(previous / "job.json"));
    fs::remove(previous / "notes.txt");
    {
        const FileLock others(run.string() + ".lock");
        ASSERT_EQ(figure("pictures.toml").status, 0);
        EXPECT_EQ(runs().size(), 3U) << "another program is at work";
    }
    ASSERT_EQ(figure("pictures.toml").status, 0);
    EXPECT_EQ(runs().size(), 1U);
}

TEST_F(FigureRunsTest, TwoAtOnceShareTheRuns) {
    write_scene("plots.toml", curves);
    const std::vector<std::string> arguments{"figure", "plots.toml",    "-o", "out",
                                             "--set",  "run.steps=300", "-v"};
    Program one(arguments, folder_.path());
    Program other(arguments, folder_.path());
    const Ended first = one.wait();
    const Ended second = other.wait();
    ASSERT_EQ(first.status, 0) << first.errors;
    ASSERT_EQ(second.status, 0) << second.errors;
    EXPECT_EQ(runs().size(), 6U);
    ASSERT_EQ(figure("plots.toml", {"--set", "run.steps=300"}, "fresh").status, 0);
    EXPECT_EQ(text("out/plots.pdf"), text("fresh/plots.pdf"));
}

TEST_F(FigureRunsTest, OthersThatArePuttingTheirFilesThereAreWaitedFor) {
    write_scene("plots.toml", curves);
    ASSERT_EQ(figure("plots.toml", {}).status, 0);
    for (const char* end : {".pdf", ".svg", ".png"})
        fs::rename(folder_ / ("out/plots" + std::string(end)),
                   folder_ / ("kept" + std::string(end)));
    write_text(folder_ / "out/plots.pdf.part", "half of");
    std::optional<FolderLock> lock(folder_ / "out");
    Program program({"figure", "plots.toml", "-o", "out"}, folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    fs::remove(folder_ / "out/plots.pdf.part");
    for (const char* end : {".pdf", ".svg", ".png"})
        fs::rename(folder_ / ("kept" + std::string(end)),
                   folder_ / ("out/plots" + std::string(end)));
    lock.reset();
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 0) << ended.errors;
}

TEST_F(FigureRunsTest, ARunThatFailsIsNamedAndOtherFiguresAreMade) {
    write_scene("plots.toml", curves);
    write_text(
        folder_ / "wild.toml",
        "[model]\nname = \"gully\"\ntime_step = 50.0\nslope = 1.0\n[grid]\nnx = 8\nny = 8\n[run]\n"
        "steps = 50\n[figure]\nwidth = \"single\"\n[[figure.panel]]\n"
        "[[figure.panel.curve]]\ny = \"mean_depth\"\n");
    const Ended ended = figure("wild.toml", {"plots.toml"});
    EXPECT_EQ(ended.status, 3) << ended.errors;
    EXPECT_NE(ended.errors.find("wild.toml: seed 1 failed: "), std::string::npos) << ended.errors;
    EXPECT_NE(ended.errors.find("wild.toml: is not made"), std::string::npos) << ended.errors;
    EXPECT_TRUE(fs::exists(folder_ / "out/plots.pdf"));
    EXPECT_FALSE(fs::exists(folder_ / "out/wild.pdf"));
}

}  // namespace
}  // namespace fumon::test
