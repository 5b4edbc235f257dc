#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/crashed_disk.h"
#include "support/disturbed.h"
#include "support/program.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* pile_scene =
    "title = \"small\"\nseed = 5\n[model]\nname = \"sandpile\"\ngrains_per_step = 20\n"
    "[grid]\nnx = 12\nny = 10\n[run]\nsteps = 24\n[image]\nwidth = 32\nheight = 24\n"
    "[frames]\nevery = 8\n[output]\navalanches = true\nmeasure_every = 2\n"
    "fields_every = 6\nbed_every = 8\n";

struct Interrupted {
    const char* name;
    const char* output;
    std::size_t states;  ///< that are tried in the short test
};

void PrintTo(const Interrupted& run, std::ostream* out) {
    *out << run.name;
}

class PowerLoss : public ::testing::TestWithParam<Interrupted> {};

/// From whatever the disk holds a run goes on to the same files, or is refused in one line; then it
/// starts anew.
TEST_P(PowerLoss, ARunGoesOnOrIsRefused) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers want to be the first library";
#endif
    const ScratchFolder folder;
    const Words words{"run", "scene.toml", "-o", "out", "-q", "--checkpoint-every", "0.00001"};
    for (const char* name : {"before", "whole"}) {
        fs::create_directory(folder / name);
        write_text(folder / name / "scene.toml", std::string(pile_scene) + GetParam().output);
    }
    fs::copy(folder / "before", folder / "run", fs::copy_options::recursive);
    ASSERT_EQ(fumon(words, folder / "whole").status, 0);
    ASSERT_EQ(disturbed_fumon(words, folder / "run", {0, 0, false, folder / "log"}).ended.status,
              0);
    const std::vector<LoggedCall> calls = calls_of_log(read_text(folder / "log"));
    ASSERT_GT(calls.size(), 50U);

    std::mt19937 random(20260101);
    int gone_on = 0;
    int complete = 0;
    int refused = 0;
    const std::size_t stride =
        tries_all_failures() ? 1 : std::max<std::size_t>(calls.size() / GetParam().states, 1);
    CrashedDisk disk(folder / "before");
    const auto restart = [&](std::size_t done, double kept) {
        SCOPED_TRACE("after call " + std::to_string(done) + " of " + std::to_string(calls.size()) +
                     ", " + name_of(calls[done - 1].call) + " " + calls[done - 1].path +
                     ", with what was not synced kept with a chance of " + std::to_string(kept));
        const fs::path left = folder / "left";
        fs::remove_all(left);
        disk.write_to(left, kept, random);
        Ended ended = fumon({"run", "--resume", "out"}, left);
        if (ended.status == 0) {
            ++(ended.errors.find("nothing is left to do") != std::string::npos ? complete
                                                                               : gone_on);
        } else {
            ++refused;
            if (tries_all_failures()) std::printf("  %s", ended.errors.c_str());
            EXPECT_EQ(ended.status, 2) << ended.errors;
            EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1)
                << ended.errors;
            EXPECT_NE(ended.errors.find("out"), std::string::npos) << ended.errors;
            Words anew = words;
            anew.emplace_back("--force");
            ended = fumon(anew, left);
            EXPECT_EQ(ended.status, 0) << ended.errors;
        }
        SCOPED_TRACE(ended.errors);
        expect_same_run(folder / "whole/out", left / "out");
    };
    for (std::size_t done = 1; done <= calls.size(); ++done) {
        disk.take(calls[done - 1]);
        constexpr std::size_t last = 6;  // among which the run becomes complete
        if (done % stride != 0 && done + last < calls.size()) continue;
        constexpr std::array<double, 4> chances{0.5, 0.0, 1.0, 0.8};
        const std::size_t tries = tries_all_failures() ? chances.size() : 1;
        for (std::size_t k = 0; k < tries; ++k) {
            restart(done, chances[(done + k) % chances.size()]);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(gone_on, 0);
    EXPECT_GT(complete, 0);
    if (tries_all_failures())
        std::printf("%s: %zu calls; %d gone on with, %d complete, %d refused\n", GetParam().name,
                    calls.size(), gone_on, complete, refused);
}

INSTANTIATE_TEST_SUITE_P(Every, PowerLoss,
                         ::testing::Values(Interrupted{"Numbers", "frames = false\nmovie = false\n",
                                                       24},
                                           Interrupted{"Pictures", "", 5},
                                           Interrupted{"MovieOnly", "frames = false\n", 4}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace fumon::test
