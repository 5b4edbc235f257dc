#include "sweep/sweep_manifest.h"

#include <gtest/gtest.h>

#include <string>

namespace fumon {
namespace {

/// A sweep of two runs that varies nothing but the seed.
SweepPlan two_seeds() {
    SweepPlan plan;
    plan.base = {{"run", {{"steps", 10}}}};
    plan.seeds = read_seeds("1:2", 1);
    for (std::uint8_t seed = 1; seed <= 2; ++seed) {
        plan.runs.push_back({0, seed, {}, 0.0});
        plan.runs.back().id.fill(seed);
    }
    return plan;
}

std::string deep_list() {
    constexpr std::size_t depth = 200000;
    return std::string(depth, '[') + std::string(depth, ']');
}

TEST(SweepManifest, ItsOwnTextGivesTheOrderBack) {
    const SweepPlan plan = two_seeds();
    const std::string text = sweep_manifest(plan, {1, 0});
    EXPECT_EQ(listed_runs(text), 2);
    const PreviousSweep previous = previous_sweep(text, plan);
    EXPECT_EQ(previous.differs, "");
    EXPECT_EQ(previous.order, (std::vector<std::size_t>{1, 0}));
}

TEST(SweepManifest, DamagedOnesAreNoPartOfAPlan) {
    const SweepPlan plan = two_seeds();
    const std::string damaged = "holds a sweep whose sweep.json is damaged";
    for (const std::string& text :
         {std::string(), std::string("[]"), std::string("{\"runs\": [1]}"),
          "{\"fumon\": \"" FUMON_VERSION "\", \"runs\": [\"x\"], \"over\": " + deep_list() + "}"}) {
        EXPECT_EQ(previous_sweep(text, plan).differs, damaged) << text.substr(0, 80);
        EXPECT_EQ(listed_runs(text), -1) << text.substr(0, 80);
    }
}

TEST(SweepManifest, AxesThatAreOnlyCalledAsThePlansAreDamage) {
    const SweepPlan plan = two_seeds();
    const std::string text = "{\"fumon\": \"" FUMON_VERSION
                             "\", \"scene\": {\"run\": {\"steps\": 10}}, \"inputs\": [], "
                             "\"seeds\": {\"first\": 1, \"last\": 2}, \"runs\": [\"x\"], "
                             "\"over\": [{\"keys\": [\"no key\"], \"values\": [\"1\"]}]}";
    EXPECT_EQ(previous_sweep(text, plan).differs, "holds a sweep whose sweep.json is damaged");
}

TEST(SweepManifest, ARunsRecordIsOfThatRun) {
    const SweepPlan plan = two_seeds();
    const Sha256& id = plan.runs[0].id;
    const std::string text = run_record_text(id, {RunStatus::done, 10, 0.5, "aa", ""});
    EXPECT_EQ(parse_run_record(text, id).steps, 10);
    EXPECT_EQ(parse_run_record(text, id).status, RunStatus::done);
    EXPECT_EQ(parse_run_record(text, plan.runs[1].id).status, RunStatus::pending);
    for (const std::string& damaged :
         {std::string("{"), text.substr(0, text.find("wall")) + "\": 1}", deep_list()})
        EXPECT_EQ(parse_run_record(damaged, id).status, RunStatus::pending)
            << damaged.substr(0, 80);
}

}  // namespace
}  // namespace fumon
