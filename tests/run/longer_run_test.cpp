#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program.h"
#include "support/resumed_run.h"
#include "support/same_run.h"

namespace fumon::test {
namespace {

class LongerRun : public ResumeTest {};

TEST_F(LongerRun, ACompleteRunGoesOnToALaterStepAsOneThatWasBegunSo) {
    for (const char* model : {"name = \"sand\"\n", "name = \"dunes\"\n",
                              "name = \"sandpile\"\ngrains_per_step = 30\n"}) {
        scene(resumed_scene(model, 24, 20, 130,
                            std::string(output_without_pictures) +
                                "fields_every = 50\nbed_every = 40\nmeasure_every = 7\n"));
        ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q", "--force"}).status, 0);
        const Ended longer = run({"run", "--resume", "out", "--set", "run.steps=170"});
        ASSERT_EQ(longer.status, 0) << longer.errors;
        EXPECT_NE(longer.errors.find("resumes at step 130 of 170\n"), std::string::npos)
            << longer.errors;
        ASSERT_EQ(run({"run", "scene.toml", "-o", "whole", "-q", "--force", "--set",
                       "run.steps=170", "--set", "frames.every=1"})
                      .status,
                  0);
        expect_same_run(out("whole"), out());
    }
}

TEST_F(LongerRun, ACompleteRunMadeLongerKeepsItsFrames) {
    scene(resumed_scene("name = \"sand\"\n", 24, 20, 300, "[output]\nfields_at = [10]\n"));
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
    const Ended longer = run({"run", "--resume", "out", "--set", "run.steps=306"});
    ASSERT_EQ(longer.status, 0) << longer.errors;
    EXPECT_NE(longer.errors.find("go on every 3 steps"), std::string::npos) << longer.errors;
    ASSERT_EQ(run({"run", "scene.toml", "-o", "whole", "-q", "--set", "run.steps=306", "--set",
                   "frames.every=3"})
                  .status,
              0);
    for (const char* file : {"measurements.csv", "fields.nc"})
        EXPECT_EQ(read_text(out() / file), read_text(out("whole") / file)) << file;
    const auto made = read_manifest(out());
    const auto whole = read_manifest(out("whole"));
    EXPECT_EQ(made["state_sha256"], whole["state_sha256"]);
    ASSERT_EQ(made["frames"].size(), 103U);
    for (std::size_t n = 0; n < 103; ++n)
        EXPECT_EQ(made["frames"][n]["pixels_sha256"], whole["frames"][n]["pixels_sha256"]) << n;
    EXPECT_EQ(made["movie"]["frames"], whole["movie"]["frames"]);
}

TEST_F(LongerRun, WhatElseChangesOfACompleteRunIsRefusedInOneLine) {
    const std::string small = resumed_scene("name = \"sand\"\n", 24, 20, 30);
    scene(small);
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q"}).status, 0);
    const auto refused = [&](std::vector<std::string> settings, const std::string& part) {
        settings.insert(settings.begin(), {"run", "--resume", "out"});
        expect_refusal(settings, part);
    };
    refused({"--set", "run.steps=50", "--set", "seed=4"}, "only run.steps may change");
    refused({"--set", "run.steps=20"}, "its 30 steps are done");
    const Ended same = run({"run", "--resume", "out", "--set", "run.steps=30"});
    EXPECT_EQ(same.errors, "out: the run is complete, nothing is left to do\n");

    ASSERT_EQ(
        run({"run", "scene.toml", "-o", "out", "-q", "--force", "--checkpoint-every", "0"}).status,
        0);
    refused({"--set", "run.steps=50"}, "its last state was not kept");
    std::string with_movie = small;
    with_movie.replace(with_movie.find("movie = false"), 13, "movie = true");
    scene(with_movie);
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q", "--force"}).status, 0);
    refused({"--set", "run.steps=50"}, "frames that were not kept");
    scene(small + "[frames]\nlogarithmic = 5\n");
    ASSERT_EQ(run({"run", "scene.toml", "-o", "out", "-q", "--force"}).status, 0);
    refused({"--set", "run.steps=50"}, "frames.logarithmic");
}

}  // namespace
}  // namespace fumon::test
