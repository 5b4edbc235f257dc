#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <thread>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
}

class SweepTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "scene.toml", small_scene()); }

    static std::vector<std::string> arguments(const std::vector<std::string>& more,
                                              const std::string& output) {
        std::vector<std::string> all{"sweep", "scene.toml", "-o", output};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    Ended sweep(const std::vector<std::string>& more, const std::string& output = "out") {
        return fumon(arguments(more, output), folder_.path());
    }

    [[nodiscard]] std::string table(const std::string& output = "out") const {
        return read_text(folder_ / output / "sweep.csv");
    }

    /// Column `name` of runs.csv; no cell of these tests has a comma.
    [[nodiscard]] std::vector<std::string> runs(const std::string& name,
                                                const std::string& output = "out") const {
        std::vector<std::string> column;
        std::size_t place = 0;
        for (const std::string& line : lines(read_text(folder_ / output / "runs.csv"))) {
            std::vector<std::string> cells;
            std::istringstream stream(line + ",");
            for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
            if (column.empty() && place == 0 && cells.front() == "run") {
                while (cells.at(place) != name) ++place;
            } else {
                column.push_back(cells.at(place));
            }
        }
        return column;
    }

    /// Starts a sweep and sends a signal as soon as a run is done.
    Ended stop(const std::vector<std::string>& more, int signal,
               const std::string& output = "out") {
        Program program(arguments(more, output), folder_.path());
        const fs::path first = folder_ / output / "runs" / "0001.json";
        for (int tries = 0; tries < 3000 && !fs::exists(first); ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        program.send(signal);
        return program.wait();
    }

    ScratchFolder folder_;
};

TEST_F(SweepTest, TellsWhatItsRunsDoubt) {
    write_text(folder_ / "scene.toml",
               "seed = 5\n[model]\nname = \"sand\"\nhop_length = \"exponential\"\n"
               "creep = \"none\"\namount = 0.5\n[grid]\nnx = 100\nny = 2\n[bed]\nlow = 0.0\n"
               "high = 3.0\n[run]\nsteps = 200\n");
    const Ended ended = sweep({"--seeds", "2"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("run 1 (seed 5): implausible: "), std::string::npos)
        << ended.errors;
    const std::string kept = read_text(folder_ / "out/runs.csv");
    EXPECT_NE(kept.find("implausible: "), std::string::npos) << kept;
    ASSERT_EQ(sweep({"--seeds", "3"}).status, 0);
    EXPECT_TRUE(read_text(folder_ / "out/runs.csv").starts_with(kept))
        << "runs that are there keep it";
}

TEST_F(SweepTest, HasEveryCombinationAndTheMeasurementsOfARun) {
    const Ended ended =
        sweep({"--over", "model.creep_rate=0.1,0.30", "--over", "bed.high=1:2:3", "--seeds", "2"});
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("12 of 12 runs are done: out/sweep.csv"), std::string::npos);
    const auto rows = lines(table());
    ASSERT_EQ(rows.size(), 1U + 12 * 5);
    EXPECT_TRUE(rows[0].starts_with("run,model.creep_rate,bed.high,seed,step,time,mean_height,"));
    std::size_t row = 1;
    int number = 1;
    for (const std::string rate : {"0.1", "0.30"}) {
        for (const std::string high : {"1", "1.5", "2"}) {
            for (const std::string seed : {"5", "6"}) {
                const std::string one = "run" + std::to_string(number);
                ASSERT_EQ(fumon({"run", "scene.toml", "-q", "-o", one, "--set",
                                 "model.creep_rate=" + rate, "--set", "bed.high=" + high, "--set",
                                 "seed=" + seed, "--set", "output.frames=false", "--set",
                                 "output.movie=false"},
                                folder_.path())
                              .status,
                          0);
                const std::string measured = read_text(folder_ / one / "measurements.csv");
                char name[16];
                std::snprintf(name, sizeof name, "%04d.csv", number);
                EXPECT_EQ(read_text(folder_ / "out/runs" / name), measured) << "the same bytes";
                const auto expected = lines(measured);
                for (std::size_t k = 1; k < expected.size(); ++k) {
                    EXPECT_EQ(rows[row++], std::to_string(number) + "," + rate + "," + high + "," +
                                               seed + "," + expected[k]);
                }
                EXPECT_EQ(runs("state_sha256")[static_cast<std::size_t>(number - 1)],
                          read_manifest(folder_ / one)["state_sha256"].get<std::string>());
                ++number;
            }
        }
    }
    EXPECT_EQ(runs("status"), std::vector<std::string>(12, "done"));
    EXPECT_EQ(runs("steps"), std::vector<std::string>(12, "20"));
    const auto manifest = nlohmann::json::parse(read_text(folder_ / "out/sweep.json"));
    EXPECT_EQ(manifest["runs"].size(), 12U);
    EXPECT_EQ(manifest["scene"]["run"]["steps"], 20);
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST_F(SweepTest, TheSameBytesForAnyNumberOfThreads) {
    const std::vector<std::string> grid{"--over", "model.creep_rate=0.1:0.5:3", "--seeds", "3",
                                        "-q"};
    for (const std::string threads : {"1", "2", "5", "20"}) {
        std::vector<std::string> more = grid;
        more.insert(more.end(), {"--threads", threads});
        ASSERT_EQ(sweep(more, "threads" + threads).status, 0);
        EXPECT_EQ(table("threads" + threads), table("threads1")) << threads;
        EXPECT_EQ(read_text(folder_ / ("threads" + threads) / "sweep.json"),
                  read_text(folder_ / "threads1/sweep.json"));
    }
}

TEST_F(SweepTest, KeysThatGoTogetherAndTheScenesOwnSweep) {
    write_text(folder_ / "scene.toml",
               small_scene() + "[sweep]\nover = [\"grid.nx+grid.ny=16,32\"]\nseeds = 2\n");
    ASSERT_EQ(sweep({"-q"}).status, 0);
    EXPECT_EQ(runs("grid.nx"), (std::vector<std::string>{"16", "16", "32", "32"}));
    EXPECT_EQ(runs("grid.ny"), (std::vector<std::string>{"16", "16", "32", "32"}));
    EXPECT_EQ(runs("seed"), (std::vector<std::string>{"5", "6", "5", "6"}));
    ASSERT_EQ(sweep({"-q", "--over", "bed.high=2", "--seeds", "9:9"}, "other").status, 0);
    EXPECT_EQ(runs("seed", "other"), (std::vector<std::string>{"9"})) << "the command line rules";
}

TEST_F(SweepTest, KeysOfListedItemsAreVaried) {
    write_text(folder_ / "scene.toml",
               "[model]\nname = \"dunes\"\n[[wind]]\nfrom = 270\n[[wind]]\nfrom = 210\n"
               "[grid]\nnx = 24\nny = 16\n[bed]\nhigh = 0.5\n[run]\nsteps = 2\n");
    const Ended ended = sweep({"--over", "wind.1.from=210,180", "--over", "wind.0.duration=0.5,1"});
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(runs("wind.1.from"), (std::vector<std::string>{"210", "210", "180", "180"}));
    EXPECT_EQ(runs("wind.0.duration"), (std::vector<std::string>{"0.5", "1", "0.5", "1"}));
}

TEST_F(SweepTest, ModelsWithOtherColumnsShareOneTable) {
    ASSERT_EQ(sweep({"-q", "--over", "model.name=sand,sandpile", "--set", "bed.kind=flat", "--set",
                     "output.fields_every=10"})
                  .status,
              0);
    const auto rows = lines(table());
    const auto commas = [](const std::string& line) {
        return std::count(line.begin(), line.end(), ',');
    };
    for (const std::string& row : rows) EXPECT_EQ(commas(row), commas(rows[0])) << row;
    EXPECT_FALSE(fs::exists(folder_ / "out/runs/0001-avalanches.csv")) << "sand has none";
    EXPECT_TRUE(fs::exists(folder_ / "out/runs/0001-fields.nc"));
}

TEST_F(SweepTest, AvalanchesAndFieldsAreThoseOfARun) {
    const std::vector<std::string> pile{"--set", "model.name=sandpile",   "--set", "run.steps=300",
                                        "--set", "output.fields_at=[100]"};
    std::vector<std::string> more{"-q", "--seeds", "5:6"};
    more.insert(more.end(), pile.begin(), pile.end());
    ASSERT_EQ(sweep(more).status, 0);
    std::vector<std::string> run{
        "run",   "scene.toml",         "-q", "-o", "run", "--set", "output.movie=false",
        "--set", "output.frames=false"};
    run.insert(run.end(), pile.begin(), pile.end());
    ASSERT_EQ(fumon(run, folder_.path()).status, 0);
    const std::string avalanches = read_text(folder_ / "run/avalanches.csv");
    EXPECT_TRUE(avalanches.starts_with("grain,size,duration,topplings,lost\n"));
    EXPECT_GT(lines(avalanches).size(), 10U);
    EXPECT_EQ(read_text(folder_ / "out/runs/0001-avalanches.csv"), avalanches);
    EXPECT_TRUE(fs::exists(folder_ / "run/fields.nc"));
    EXPECT_TRUE(fs::exists(folder_ / "out/runs/0002-fields.nc"));
    const auto manifest = read_manifest(folder_ / "run");
    EXPECT_EQ(manifest["avalanches"], "avalanches.csv");
    EXPECT_EQ(manifest["fields"], "fields.nc");

    more.insert(more.end(), {"--set", "output.avalanches=false"});
    ASSERT_EQ(sweep(more, "without").status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "without/runs/0001-avalanches.csv"));
}

TEST_F(SweepTest, BedFilesCanBeSwept) {
    fs::create_directories(folder_ / "data");
    const std::string head = "ncols 3\nnrows 2\ncellsize 1\nxllcorner 0\nyllcorner 0\n";
    write_text(folder_ / "data/a.asc", head + "1 1 1\n1 1 1\n");
    write_text(folder_ / "data/b.asc", head + "2 2 2\n2 2 2\n");
    const std::vector<std::string> beds{
        "-q",    "--over",     "bed.file=data/a.asc,data/b.asc", "--set", "model.name=static",
        "--set", "run.steps=1"};
    ASSERT_EQ(sweep(beds).status, 0);
    EXPECT_EQ(runs("bed.file"), (std::vector<std::string>{"data/a.asc", "data/b.asc"}));
    EXPECT_NE(table().find("2,data/b.asc,5,0,0,2,0,2,2,"), std::string::npos) << table();

    write_text(folder_ / "data/b.asc", head + "2 2 2\n2 2 3\n");
    const Ended changed = sweep(beds);
    EXPECT_EQ(changed.status, 2);
    EXPECT_EQ(changed.errors,
              "out holds another sweep: data/b.asc has changed since; name another folder, or "
              "replace it with --force\n");
}

TEST_F(SweepTest, AFailingCombinationIsToldAndTheOthersAreKept) {
    std::vector<std::string> grid = settings_that_leave_the_range();
    grid.insert(grid.end(), {"--over", "bed.high=1,999999,2"});
    const Ended ended = sweep(grid);
    EXPECT_EQ(ended.status, 3);
    EXPECT_EQ(ended.errors.find("run 2 (bed.high=999999, seed 5) failed: the bed height became "),
              0U)
        << ended.errors;
    EXPECT_EQ(runs("status"), (std::vector<std::string>{"done", "failed", "done"}));
    const std::size_t before_its_fault = lines(read_text(folder_ / "out/runs/0002.csv")).size() - 1;
    EXPECT_GT(before_its_fault, 0U);
    EXPECT_LT(before_its_fault, 5U);
    EXPECT_EQ(lines(table()).size(), 1U + 2 * 5 + before_its_fault);
    const Ended again = sweep(grid);
    EXPECT_EQ(again.status, 3) << "it is tried again";
    EXPECT_NE(again.errors.find("run 2 ("), std::string::npos) << again.errors;
    EXPECT_EQ(again.errors.find("run 1 ("), std::string::npos) << again.errors;
}

TEST_F(SweepTest, AnInterruptKeepsWhatIsDoneAndTheSameCommandGoesOn) {
#ifdef FUMON_SANITIZED
    constexpr const char* steps = "800";  // which take as long as 4000 otherwise
#else
    constexpr const char* steps = "4000";
#endif
    const std::vector<std::string> grid{
        "--over", "model.creep_rate=0.1:0.5:5",      "--seeds",   "4",
        "--set",  std::string("run.steps=") + steps, "--set",     "grid.nx=100",
        "--set",  "output.measure_every=400",        "--threads", "2"};
    ASSERT_EQ(sweep(grid, "whole").status, 0);
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
        const std::string output = "stopped" + std::to_string(signal);
        const Ended stopped = stop(grid, signal, output);
        EXPECT_EQ(stopped.status, 128 + signal) << stopped.errors;
        const fs::path first = folder_ / output / "runs/0001.json";
        ASSERT_TRUE(fs::exists(first));
        const auto before = fs::last_write_time(first);
        if (signal != SIGKILL) {
            EXPECT_NE(stopped.errors.find("the same command continues from here"),
                      std::string::npos)
                << stopped.errors;
            const std::string part = table(output);
            EXPECT_GT(lines(part).size(), 1U);
            EXPECT_LT(part.size(), table("whole").size());
            const auto status = runs("status", output);
            EXPECT_EQ(status.front(), "done");
            EXPECT_EQ(status.back(), "pending");
        }
        const Ended again = sweep(grid, output);
        EXPECT_EQ(again.status, 0) << again.errors;
        EXPECT_NE(again.errors.find("of 20 runs were there already"), std::string::npos)
            << again.errors;
        EXPECT_EQ(table(output), table("whole")) << "the same bytes";
        EXPECT_EQ(fs::last_write_time(first), before) << "run 1 was not made again";
        EXPECT_EQ(runs("state_sha256", output), runs("state_sha256", "whole"));
    }
}

TEST_F(SweepTest, MoreSeedsAndValuesExtendIt) {
    const auto grid = [](const std::string& rates, const std::string& seeds) {
        return std::vector<std::string>{"--over", "model.creep_rate=" + rates, "--seeds", seeds};
    };
    ASSERT_EQ(sweep(grid("0.1,0.2", "2")).status, 0);
    const std::string first = table();
    const Ended wider = sweep(grid("0.05,0.1,0.20", "3"));
    ASSERT_EQ(wider.status, 0) << wider.errors;
    EXPECT_NE(wider.errors.find("4 of 9 runs were there already"), std::string::npos)
        << wider.errors;
    EXPECT_EQ(runs("seed"), (std::vector<std::string>{"5", "6", "5", "6", "5", "6", "7", "7", "7"}))
        << "runs keep their numbers";
    EXPECT_EQ(lines(table()).size(), 1U + 9 * 5);
    EXPECT_TRUE(table().starts_with(first.substr(0, first.find("\n3,")))) << "and rows their place";
    EXPECT_NE(table().find("\n3,0.20,5,0,"), std::string::npos) << "values as written now";

    ASSERT_EQ(sweep(grid("0.05,0.1,0.20", "3"), "fresh").status, 0);
    auto extended = runs("state_sha256");
    auto fresh = runs("state_sha256", "fresh");
    std::sort(extended.begin(), extended.end());
    std::sort(fresh.begin(), fresh.end());
    EXPECT_EQ(extended, fresh);
}

TEST_F(SweepTest, AnotherSweepIsRefusedUnlessForced) {
    const std::vector<std::string> first{"-q", "--over", "model.creep_rate=0.1,0.2", "--seeds",
                                         "2"};
    ASSERT_EQ(sweep(first).status, 0);
    const std::string before = table();
    const auto refused = [&](const std::vector<std::string>& more, const std::string& why) {
        const Ended ended = sweep(more);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, "out holds another sweep: " + why +
                                    "; name another folder, or replace it with --force\n");
        EXPECT_EQ(table(), before);
    };
    refused({"--over", "model.creep_rate=0.1,0.3", "--seeds", "2"},
            "it has model.creep_rate=0.2, which is no longer among the values");
    refused({"--over", "model.creep_rate=0.1,0.2"}, "it has the seeds 5 to 6, now 5 to 5");
    refused({"--over", "bed.high=1,2", "--seeds", "2"}, "it varies model.creep_rate, now bed.high");
    refused({"--over", "model.creep_rate=0.1,0.2", "--seeds", "2", "--set", "run.steps=21"},
            "its scene has run.steps = 20, now 21");
    std::vector<std::string> recoloured = first;
    recoloured.insert(recoloured.end(), {"--set", "look.palette=viridis"});
    EXPECT_EQ(sweep(recoloured).status, 0) << "how it would look does not matter";

    const Ended forced = sweep({"-q", "--over", "bed.high=2", "--force"});
    EXPECT_EQ(forced.status, 0) << forced.errors;
    EXPECT_EQ(runs("bed.high"), (std::vector<std::string>{"2"}));
    EXPECT_FALSE(fs::exists(folder_ / "out/runs/0002.csv")) << "the former sweep is gone";
}

TEST_F(SweepTest, RecordsOfAnotherRunOrVersionAreNotTaken) {
    const std::vector<std::string> two{"--seeds", "2"};
    ASSERT_EQ(sweep(two).status, 0);
    const std::string whole = table();
    const fs::path record = folder_ / "out/runs/0001.json";
    auto json = nlohmann::json::parse(read_text(record));
    json["id"] = std::string(64, '0');
    write_text(record, json.dump());
    write_text(folder_ / "out/runs/0001.csv", "step,time\n");
    fs::remove(folder_ / "out/runs/0002.csv");
    const Ended again = sweep(two);
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(again.errors, "2 of 2 runs are done: out/sweep.csv\n") << "none was there already";
    EXPECT_EQ(table(), whole);

    auto manifest = nlohmann::ordered_json::parse(read_text(folder_ / "out/sweep.json"));
    manifest["fumon"] = "0.0.1";
    write_text(folder_ / "out/sweep.json", manifest.dump());
    EXPECT_EQ(sweep(two).errors,
              "out holds another sweep: it was made by fumon 0.0.1, this is " FUMON_VERSION
              "; name another folder, or replace it with --force\n");
    write_text(folder_ / "out/sweep.json", "{");
    EXPECT_EQ(sweep(two).errors,
              "out holds a sweep whose sweep.json is damaged; name another folder, or replace it "
              "with --force\n");
}

TEST_F(SweepTest, OneProgramAtATimeWorksInAFolder) {
    Program first(arguments({"--seeds", "40", "--set", "run.steps=100000"}, "out"), folder_.path());
    for (int tries = 0; tries < 3000 && !fs::exists(folder_ / "out/runs.csv"); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const Ended second = sweep({"--seeds", "40", "--set", "run.steps=100000"});
    EXPECT_EQ(second.status, 2);
    EXPECT_EQ(second.errors,
              "another fumon is working in out; wait for it or name another folder\n");
    first.send(SIGINT);
    EXPECT_EQ(first.wait().status, 130);
}

TEST_F(SweepTest, WhatIsWrongIsLocatedAndWritesNothing) {
    const auto refused = [&](const std::vector<std::string>& more, const std::string& line) {
        const Ended ended = sweep(more);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, line + "\n");
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    refused({}, "scene.toml: nothing to vary; give --over key=v1,v2 or --seeds 10");
    refused({"--over", "model.creep_rate=0.1,2"},
            "--over 1:22: model.creep_rate is 2; it takes a number > 0 and ≤ 1 (share per step)");
    refused({"--over", "bed.high=1,2", "--over", "model.creep_rat=1"},
            "--over 2:1: unknown key model.creep_rat; did you mean \"model.creep_rate\"?");
    refused({"--over", "run.steps=1:10:5"},
            "--over 1:11: run.steps is 3.25; it takes a whole number 0 … 1e+15 (steps)");
    refused({"--over", "run.steps=1,2", "--over", "run.steps=3"},
            "--over 2:1: run.steps is varied twice; give all its values at once");
    refused({"--over", "model.creep_rate=0.1,0.10"},
            "--over 1:22: model.creep_rate=0.10, seed 5 is the same run as model.creep_rate=0.1, "
            "seed 5; a sweep makes no pictures and runs each scene once");
    refused({"--over", "bed.file=gone.asc", "--set", "bed.kind=file"},
            "--over 1:10: bed.file \"gone.asc\" does not exist (looked for gone.asc); paths are "
            "relative to the working folder");
    refused({"--over", "model.hop_base=1,1000"},
            "scene.toml:4:8: the highest sand (0.9979 heights of grid.height_unit = 1 m) would hop "
            "1002 sites, further than the box of 24; raise grid.height_unit, lower the bed or "
            "shorten the hops (with model.hop_base=1000, seed 5)");
    refused({"--over", "bed.high=0:1:1000", "--over", "bed.low=0:1:1000"},
            "the sweep has more than 100000 runs; vary fewer values or seeds at once");
    refused(
        {"--seeds", "2", "--set", "output.measurements=false"},
        "--set 1:21: output.measurements is false, but a sweep needs measurements; leave it true");
}

TEST_F(SweepTest, AFullDiskFailsRunsAndLeavesNoHalfFile) {
    const fs::path disk = folder_ / "disk";
    fs::create_directory(disk);
    const std::string mount = "mount -t tmpfs -o size=256k tmpfs " + disk.string() + " 2>/dev/null";
    if (std::system(mount.c_str()) != 0)
        GTEST_SKIP() << "cannot mount a small tmpfs here (needs root)";
    const Ended ended = sweep(
        {"--seeds", "4", "--set", "run.steps=2000", "--set", "output.measure_every=1"}, "disk/out");
    EXPECT_EQ(ended.status, 3);
    EXPECT_NE(ended.errors.find("failed: cannot write disk/out/runs/"), std::string::npos)
        << ended.errors;
    for (const auto& entry : fs::recursive_directory_iterator(disk / "out"))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    EXPECT_EQ(std::system(("umount " + disk.string()).c_str()), 0);
}

}  // namespace
}  // namespace fumon::test
