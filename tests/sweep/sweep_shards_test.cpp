#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "files/hash.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

class SweepShardsTest : public ::testing::Test {
  protected:
    void SetUp() override {
        write_text(folder_ / "scene.toml", small_scene());
        ASSERT_EQ(sweep("whole").status, 0);
    }

    /// Runs of three lengths, two seeds each.
    [[nodiscard]] static std::vector<std::string> words(const std::string& output,
                                                        const std::vector<std::string>& more) {
        std::vector<std::string> all{"sweep",   "scene.toml", "--over", "run.steps=10,40,20",
                                     "--seeds", "2",          "-o",     output};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    Ended sweep(const std::string& output, const std::vector<std::string>& more = {},
                const std::vector<std::string>& environment = {}) {
        return fumon(words(output, more), folder_.path(), environment);
    }

    [[nodiscard]] Sha256 table(const std::string& output) const {
        return text_hash(read_text(folder_ / output / "sweep.csv"));
    }

    ScratchFolder folder_;
};

std::string shard(int number, int of) {
    return std::to_string(number) + "/" + std::to_string(of);
}

TEST_F(SweepShardsTest, TheSameTableForAnyNumberOfShardsInOneFolderOrTheirOwn) {
    for (const int shards : {1, 2, 3, 7}) {
        const std::string together = "together" + std::to_string(shards);
        const std::string merged = "merged" + std::to_string(shards);
        std::vector<std::string> from{"--merge"};
        for (int number = shards; number >= 1; --number) {
            ASSERT_EQ(sweep(together, {"--shard", shard(number, shards), "-q"}).status, 0);
            EXPECT_FALSE(fs::exists(folder_ / together / "sweep.csv"));
            const std::string own = "own" + std::to_string(shards) + "-" + std::to_string(number);
            if (shards == 7 && number == 7) continue;  // of six runs
            ASSERT_EQ(sweep(own, {"--shard", shard(number, shards), "-q"}).status, 0);
            from.insert(from.end(), {"--from", own});
        }
        const Ended ended = sweep(together, {"--merge"});
        EXPECT_EQ(ended.status, 0) << ended.errors;
        EXPECT_EQ(ended.errors, "6 of 6 runs are done: " + together + "/sweep.csv\n");
        EXPECT_EQ(table(together), table("whole"));
        EXPECT_EQ(read_text(folder_ / together / "sweep.json"),
                  read_text(folder_ / "whole/sweep.json"));
        EXPECT_EQ(sweep(merged, from).status, 0);
        EXPECT_EQ(table(merged), table("whole"));
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / together))
            EXPECT_NE(entry.path().extension(), ".lock") << entry.path();
    }
}

TEST_F(SweepShardsTest, ShardsBesideOneAnotherInOneFolder) {
    std::vector<std::unique_ptr<Program>> programs;
    for (const char* one : {"1/3", "2/3", "3/3", "2/3", "1/2"}) {  // one twice, and one of others
        programs.push_back(std::make_unique<Program>(
            words("beside", {"--shard", one, "--threads", "1"}), folder_.path()));
    }
    for (const auto& program : programs) {
        const Ended ended = program->wait();
        EXPECT_EQ(ended.status, 0) << ended.errors;
    }
    const Ended ended = sweep("beside", {"--merge", "-q"});
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_EQ(table("beside"), table("whole"));
}

TEST_F(SweepShardsTest, NoTwoProgramsMakeOneRun) {
    std::vector<std::unique_ptr<Program>> programs;
    for (int n = 0; n < 3; ++n) {
        programs.push_back(std::make_unique<Program>(
            std::vector<std::string>{"sweep", "scene.toml", "--over", "model.creep_rate=0.1,0.2",
                                     "--set", "grid.nx=100", "--set", "grid.ny=100", "--set",
                                     "run.steps=400", "--threads", "1", "-o", "out", "--shard",
                                     "1/1"},
            folder_.path()));
    }
    for (const auto& program : programs) {
        const Ended ended = program->wait();
        EXPECT_EQ(ended.status, 0) << ended.errors;
        EXPECT_NE(ended.errors.find("2 of 2 runs are done"), std::string::npos) << ended.errors;
    }
}

TEST_F(SweepShardsTest, AMissingShardIsNamedAndDoneAgain) {
    ASSERT_EQ(sweep("out", {"--shard", "1/3", "-q"}).status, 0);
    ASSERT_EQ(sweep("out", {"--shard", "3/3", "-q"}).status, 0);
    Program killed(
        words("out", {"--shard", "2/3", "--threads", "1", "--set", "output.movie=false"}),
        folder_.path());
    for (int tries = 0; tries < 3000 && !fs::exists(folder_ / "out/runs/0002.lock"); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    killed.send(SIGKILL);
    killed.wait();
    fs::remove(folder_ / "out/runs/0004.json");  // had it come so far
    const Ended early = sweep("out", {"--merge"});
    EXPECT_EQ(early.status, 3);
    EXPECT_NE(early.errors.find("shard 2/3 is missing: "), std::string::npos) << early.errors;
    EXPECT_EQ(early.errors.find("shard 1/3"), std::string::npos) << early.errors;
    EXPECT_EQ(early.errors.find("shard 3/3"), std::string::npos) << early.errors;
    EXPECT_NE(early.errors.find("out: the table is not written, since "), std::string::npos)
        << early.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out/sweep.csv"));
    ASSERT_EQ(sweep("out", {"--shard", "2/3", "-q"}).status, 0);
    EXPECT_EQ(sweep("out", {"--merge"}).status, 0);
    EXPECT_EQ(table("out"), table("whole"));
}

TEST_F(SweepShardsTest, FailedRunsAreInTheTableAsWithoutShards) {
    const auto failing = [&](const std::string& output, std::vector<std::string> more) {
        std::vector<std::string> all{"sweep", "scene.toml", "--over", "bed.high=1,999999,2",
                                     "-o",    output};
        for (const std::string& word : settings_that_leave_the_range()) all.push_back(word);
        all.insert(all.end(), more.begin(), more.end());
        return fumon(all, folder_.path());
    };
    EXPECT_EQ(failing("alone", {}).status, 3);
    for (const char* one : {"1/2", "2/2"}) failing("a", {"--shard", one});
    const Ended ended = failing("b", {"--merge", "--from", "a"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_NE(ended.errors.find("1 of 3 runs failed"), std::string::npos) << ended.errors;
    EXPECT_EQ(table("b"), table("alone"));
    EXPECT_NE(read_text(folder_ / "b/runs.csv").find(",failed,"), std::string::npos);
    EXPECT_NE(read_text(folder_ / "b/runs.csv").find("the bed height became "), std::string::npos);
}

TEST_F(SweepShardsTest, TheJobsEnvironmentSaysWhichShard) {
    const Ended ended =
        sweep("out", {"--shard", "slurm"}, {"SLURM_ARRAY_TASK_ID=2", "SLURM_ARRAY_TASK_COUNT=3"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.errors, "shard 2/3: 2 of 2 runs are done: out\n");
    EXPECT_EQ(
        sweep("out", {"--shard", "mpi", "-q"}, {"OMPI_COMM_WORLD_RANK=0", "OMPI_COMM_WORLD_SIZE=3"})
            .status,
        0);
    const Ended merged = sweep("out", {"--merge"});
    EXPECT_EQ(merged.status, 3);
    EXPECT_EQ(merged.errors,
              "shard 3/3 is missing: its 2 runs, from run 5 on\n"
              "out: the table is not written, since 2 of 6 runs are missing\n");
}

TEST_F(SweepShardsTest, UnderMpirunTheLastProgramWritesTheTable) {
    const auto environment = [](int rank) {
        return std::vector<std::string>{"OMPI_COMM_WORLD_RANK=" + std::to_string(rank),
                                        "OMPI_COMM_WORLD_SIZE=3"};
    };
    std::vector<std::unique_ptr<Program>> programs;
    for (const int rank : {1, 2})
        programs.push_back(
            std::make_unique<Program>(words("out", {}), folder_.path(), environment(rank)));
    for (const auto& program : programs) EXPECT_EQ(program->wait().status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/sweep.csv")) << "the first rank is missing";
    const Ended ended = sweep("out", {}, environment(0));
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.errors,
              "mpirun has started 3 programs: each does its share, and the last one to end writes "
              "the table (--shard none: each does all)\n"
              "shard 1/3: 2 of 2 runs are done: out\n"
              "6 of 6 runs are done: out/sweep.csv\n");
    EXPECT_EQ(table("out"), table("whole"));
    programs.clear();
    for (const int rank : {0, 1, 2})
        programs.push_back(std::make_unique<Program>(words("beside", {"--threads", "1"}),
                                                     folder_.path(), environment(rank)));
    for (const auto& program : programs) EXPECT_EQ(program->wait().status, 0);
    EXPECT_EQ(table("beside"), table("whole"));
    EXPECT_EQ(sweep("alone", {"--shard", "none", "-q"}, environment(1)).errors, "");
    EXPECT_EQ(table("alone"), table("whole"));
}

TEST_F(SweepShardsTest, WhatDoesNotFitIsRefused) {
    const auto refused = [&](const std::vector<std::string>& more, const std::string& line) {
        const Ended ended = sweep("new", more);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.errors, line + "\n");
        EXPECT_FALSE(fs::exists(folder_ / "new"));
    };
    refused(
        {"--shard", "4/3"},
        "--shard 4/3 is shard 4 of 3; it takes N/OF with N from 1 to OF and at most 10000 shards, "
        "as 3/16");
    refused({"--shard", "1/2", "--merge"},
            "fumon sweep: --shard and --merge do not go together; try `fumon sweep --help`");
    refused({"--from", "whole"}, "fumon sweep: --from needs --merge too; try `fumon sweep --help`");
    refused({"--shard", "slurm"},
            "--shard slurm: SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT are not set; submit the "
            "job with sbatch --array=1-16, or name the shard, as --shard 3/16");
    fs::create_directory(folder_ / "empty");
    EXPECT_EQ(sweep("new", {"--merge", "--from", "empty"}).errors,
              "--from empty: holds no sweep (no sweep.json); name the folder of a shard\n");
}

TEST_F(SweepShardsTest, AJobScriptIsPrinted) {
    const Ended ended = sweep("out", {"--slurm", "3"});
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.output.find("#SBATCH --array=1-3\n"), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("sweep scene.toml --over run.steps=10,40,20 --seeds 2 -o out"),
              std::string::npos)
        << ended.output;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace fumon::test
