#include "shards/shard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "shards/slurm_script.h"
#include "support/command.h"
#include "support/program.h"

namespace fumon {
namespace {

Environment environment(std::map<std::string, std::string> values) {
    return [values = std::move(values)](const char* name) -> std::optional<std::string> {
        const auto found = values.find(name);
        if (found == values.end()) return std::nullopt;
        return found->second;
    };
}

std::string read(const std::string& text, std::map<std::string, std::string> values = {}) {
    return shard_text(read_shard(text, environment(std::move(values))));
}

TEST(Shard, IsReadFromTextAndFromTheJobsEnvironment) {
    EXPECT_EQ(read("3/16"), "3/16");
    EXPECT_EQ(read("slurm", {{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "16"}}),
              "3/16");
    EXPECT_EQ(read("slurm", {{"SLURM_ARRAY_TASK_ID", "4"},
                             {"SLURM_ARRAY_TASK_COUNT", "4"},
                             {"SLURM_ARRAY_TASK_MIN", "0"},
                             {"SLURM_ARRAY_TASK_MAX", "6"},
                             {"SLURM_ARRAY_TASK_STEP", "2"}}),
              "3/4")
        << "an array from 0 in steps of 2";
    EXPECT_EQ(read("mpi", {{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "8"}}), "1/8");
    EXPECT_EQ(read("mpi", {{"PMI_RANK", "7"}, {"PMI_SIZE", "8"}}), "8/8");
    EXPECT_EQ(read("mpi", {{"SLURM_PROCID", "1"}, {"SLURM_NTASKS", "2"}}), "2/2");
}

TEST(Shard, RefusesWhatIsNone) {
    for (const char* text : {"", "3", "0/4", "5/4", "a/4", "1/0", "1/4x", "-1/4", "1/20000", "pbs"})
        EXPECT_THROW(read(text), InputError) << text;
    EXPECT_THROW(read("slurm"), InputError);
    EXPECT_THROW(read("mpi"), InputError);
    EXPECT_THROW(read("slurm", {{"SLURM_ARRAY_TASK_ID", "7"},
                                {"SLURM_ARRAY_TASK_COUNT", "3"},
                                {"SLURM_ARRAY_TASK_MIN", "1"},
                                {"SLURM_ARRAY_TASK_MAX", "7"},
                                {"SLURM_ARRAY_TASK_STEP", "1"}}),
                 InputError)
        << "--array=1,5,7 does not say how many shards there are";
}

TEST(Shard, MpirunTellsItsRankUnasked) {
    const auto rank = [](std::map<std::string, std::string> values) {
        const auto found = rank_of_mpirun(environment(std::move(values)));
        return found ? shard_text(found->shard) + " of " + std::to_string(found->beside) + " here"
                     : "none";
    };
    EXPECT_EQ(rank({{"OMPI_COMM_WORLD_RANK", "2"},
                    {"OMPI_COMM_WORLD_SIZE", "8"},
                    {"OMPI_COMM_WORLD_LOCAL_SIZE", "4"}}),
              "3/8 of 4 here");
    EXPECT_EQ(rank({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}, {"MPI_LOCALNRANKS", "2"}}),
              "1/2 of 2 here");
    EXPECT_EQ(rank({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "1"}}), "none");
    EXPECT_EQ(rank({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "8"}}), "none")
        << "so has a job's own script, which is one program";
    EXPECT_EQ(rank({}), "none");
}

TEST(Shard, SharesAreAsLongAsOneAnother) {
    EXPECT_EQ(shares_of({1, 1, 1, 1, 1}, 2), (std::vector<int>{1, 2, 1, 2, 1}));
    EXPECT_EQ(shares_of({1, 2, 9, 3, 4}, 2), (std::vector<int>{1, 2, 1, 2, 2}))
        << "9 + 1 against 4 + 3 + 2";
    EXPECT_EQ(shares_of({5}, 3), (std::vector<int>{1}));
    EXPECT_TRUE(shares_of({}, 3).empty());
    std::vector<double> lengths;
    for (int i = 0; i < 100; ++i) lengths.push_back(1.0 + (i * 37) % 91);
    constexpr int shards = 7;
    std::vector<double> loads(shards);
    const std::vector<int> shares = shares_of(lengths, shards);
    for (std::size_t i = 0; i < lengths.size(); ++i)
        loads[static_cast<std::size_t>(shares[i] - 1)] += lengths[i];
    const auto [least, most] = std::ranges::minmax(loads);
    EXPECT_LT(most - least, 0.02 * most);
}

TEST(Shard, AScriptsWordsAreThoseOfTheCommand) {
    EXPECT_EQ(shell_word("model.creep_rate=0.1:0.5:5"), "model.creep_rate=0.1:0.5:5");
    EXPECT_EQ(shell_word("a b"), "'a b'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
    const test::ScratchFolder folder;
    const std::vector<std::string> words{
        "sweep", "my scene.toml", "--set", "title=\"it's $HOME\"", "-o", "out"};
    test::write_text(folder / "job.sh", slurm_script({"fumon-sweep", words, 3}));
    test::write_text(folder / "echo", "#!/bin/sh\nfor word in \"$@\"; do echo \"$word\"; done\n");
    test::write_text(folder / "sbatch",
                     "#!/bin/sh\nfor word in \"$@\"; do echo \"$word\"; done >> " +
                         (folder / "submitted").string() + "\n");
    const std::string task = "cd " + folder.path().string() +
                             " && chmod +x echo sbatch && PATH=" + folder.path().string() +
                             ":$PATH FUMON=./echo SLURM_ARRAY_JOB_ID=77 SLURM_ARRAY_TASK_MIN=1 ";
    const test::Spoken second = test::run_command(task + "SLURM_ARRAY_TASK_ID=2 bash job.sh");
    EXPECT_EQ(
        second.words,
        "sweep\nmy scene.toml\n--set\ntitle=\"it's $HOME\"\n-o\nout\n--shard\n2/3\n--threads\n1\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "submitted"));
    test::run_command(task + "SLURM_CPUS_PER_TASK=4 SLURM_ARRAY_TASK_ID=1 bash job.sh");
    const std::string submitted = test::read_text(folder / "submitted");
    EXPECT_NE(submitted.find("--dependency=afterany:77\n"), std::string::npos) << submitted;
    const std::string wrap = submitted.substr(submitted.find("--wrap=") + 7);
    EXPECT_EQ(test::run_command("cd " + folder.path().string() + " &&" + wrap).words,
              "sweep\nmy scene.toml\n--set\ntitle=\"it's $HOME\"\n-o\nout\n--merge\n");
}

}  // namespace
}  // namespace fumon
