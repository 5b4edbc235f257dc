#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kills = 10;  // of each scene: 50 in all

struct KilledRun {
    const char* name;
    const char* scene;
};

/// With pictures of all kinds, tables and fields; one makes a movie and keeps no frames.
const KilledRun cases[] = {
    {"Sand",
     "seed = 3\n[model]\nname = \"sand\"\norder = \"random-sequential\"\n[grid]\nnx = 100\nny = "
     "80\n[run]\nsteps = 750\n[frames]\nevery = 15\n[output]\nfields_every = 50\nbed_every = "
     "200\n"},
    {"Profile",
     "[model]\nname = \"sand\"\norder = \"random-sequential\"\ncreep = \"profile\"\n[grid]\nnx = "
     "4000\nny = 1\n[run]\nsteps = 800\n[frames]\nevery = 25\n"},
    {"Pile",
     "[model]\nname = \"sandpile\"\norder = \"first-in-first-out\"\ndrop_direction = "
     "\"cycling\"\ngrains_per_step = 20\n[grid]\nnx = 40\nny = 40\n[run]\nsteps = "
     "2500\n[frames]\nevery = 25\n[output]\nframes = false\nfields_every = 100\n"},
    {"Gully",
     "[model]\nname = \"gully\"\ntransport = \"as-printed\"\n[bed]\nhigh = 0.01\n[grid]\nnx = "
     "60\nny = 60\n[run]\nsteps = 300\n[frames]\nevery = 10\n[output]\nfields_every = 20\n"},
    {"Air",
     "[model]\nname = \"airflow\"\nnz = 24\nflights = true\nshown_paths = 4\nbed_amplitude = "
     "0.1\nlid_speed = 0.2\nlaunch_angles = [10.0]\n[grid]\nnx = 80\n[run]\nsteps = "
     "700\n[frames]\nevery = 25\n[output]\nfields_every = 50\n"},
};

class RandomKills : public ::testing::TestWithParam<KilledRun> {};

// SIGKILL at moments drawn uniformly from the run's usual length. The draws are those of a fixed
// seed, but what they hit depends on the machine.
TEST_P(RandomKills, ARunGoneOnWithIsTheUninterruptedOne) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml",
               std::string(GetParam().scene) + "[image]\nwidth = 96\nheight = 72\n");
    const auto start = Clock::now();
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "whole", "-q"}, folder.path()).status, 0);
    std::chrono::duration<double> whole = Clock::now() - start;

    // A run that was killed before its first checkpoint begins anew.
    const auto next = [&]() -> std::vector<std::string> {
        if (fs::exists(folder / "out/checkpoint.fumon")) return {"run", "--resume", "out"};
        return {"run", "scene.toml", "-o", "out", "--force"};
    };
    std::mt19937 random(7);
    std::uniform_real_distribution<double> moment(0.1, 0.9);
    int killed = 0;
    int gone_on = 0;
    // On a machine that is busy more kills come before the first checkpoint.
    while (killed < kills || (gone_on <= kills / 3 && killed < 4 * kills)) {
        const bool resume = fs::exists(folder / "out/checkpoint.fumon");
        std::vector<std::string> arguments = next();
        arguments.insert(arguments.end(), {"-q", "--checkpoint-every", "0.00001"});
        Program program(arguments, folder.path());
        std::this_thread::sleep_for(moment(random) * whole);
        program.send(SIGKILL);
        const Ended ended = program.wait();
        gone_on += resume ? 1 : 0;
        if (ended.status == 128 + SIGKILL) {
            ++killed;
            continue;
        }
        ASSERT_EQ(ended.status, 0) << ended.errors;
        whole *= 0.8;  // the machine was busier while the first run took its time
        expect_same_run(folder / "whole", folder / "out");
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_EQ(fumon(next(), folder.path()).status, 0);
    expect_same_run(folder / "whole", folder / "out");
    EXPECT_GT(gone_on, kills / 3) << "most kills come after a checkpoint";
}

INSTANTIATE_TEST_SUITE_P(EveryModel, RandomKills, ::testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace fumon::test
