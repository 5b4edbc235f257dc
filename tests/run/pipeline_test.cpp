#include "run/pipeline.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/state_archive.h"
#include "models/shared/check_finite.h"
#include "run/bounded_queue.h"
#include "run/frame_list.h"
#include "run/manifest.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// A flat bed in which one cell turns NaN at a given step.
class SpoiledModel : public Model {
  public:
    explicit SpoiledModel(std::int64_t spoiled_at) : spoiled_at_(spoiled_at), bed_(24, 20, 1.0) {}
    [[nodiscard]] std::string_view name() const override { return "spoiled"; }
    void step() override {
        if (++steps_ == spoiled_at_) bed_(3, 4) = std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] Snapshot snapshot() const override {
        return {steps_, static_cast<double>(steps_), "steps", bed_, {}, {}};
    }
    [[nodiscard]] std::vector<StateField> state() const override {
        return {{"bed", bed_.values()}};
    }
    void serialise(StateArchive& archive) override {
        archive.count("steps", steps_);
        archive.values("bed", bed_.values());
    }

  private:
    std::int64_t spoiled_at_;
    std::int64_t steps_ = 0;
    Grid bed_;
};

TEST(Pipeline, AFieldThatTurnsNaNIsReportedAndEarlierFramesAreKept) {
    const ScratchFolder folder;
    const Scene scene = parse_scene(small_scene(), "scene.toml", "");
    SpoiledModel model(12);
    RunFolder run(folder / "out", false);
    Progress progress(Verbosity::quiet, 0);
    const RunOutcome outcome = run_pipeline(model, scene, {}, outputs_in(run, scene), {}, progress,
                                            [&](const DrawingRecord&) {
                                                run.create({true, false, false});
                                            });
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(error_text(outcome.error),
              "the bed height became nan at cell (3, 4), step 15; try smaller rates (`fumon "
              "describe` lists the ranges)");
    ASSERT_EQ(outcome.frames, 3) << "steps 0, 5 and 10";
    FrameListReader frames(run.frame_list());
    for (std::int64_t number = 0; number < outcome.frames; ++number) {
        EXPECT_EQ(frames.next().step, 5 * number);
        EXPECT_TRUE(std::filesystem::exists(run.frame(number)));
    }
    EXPECT_EQ(outcome.movie.frames, 3) << "the movie holds what was made";
    EXPECT_TRUE(std::filesystem::exists(run.movie()));
    EXPECT_TRUE(outcome.recorded.measurements);
}

TEST(Pipeline, EveryFieldIsCheckedAndTheMessageNamesItsPlaceAndTime) {
    Snapshot snapshot;
    snapshot.step = 15;
    snapshot.time = 1.5;
    snapshot.time_unit = "s";
    snapshot.bed = Grid(6, 1, 1.0);
    snapshot.fields = {{"water_depth", "", "m", Grid(6, 1, 0.01)}};
    SnapshotSection section;
    section.fields = {{"velocity_x", "", "m/s", Grid(6, 4, 0.5)}};
    snapshot.section = std::make_shared<const SnapshotSection>(section);
    EXPECT_NO_THROW(check_finite(snapshot));
    const auto message = [&] {
        try {
            check_finite(snapshot);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string end =
        ", step 15 (1.5 s); try smaller rates (`fumon describe` lists the ranges)";
    section.fields[0].values(2, 3) = std::numeric_limits<double>::quiet_NaN();
    snapshot.section = std::make_shared<const SnapshotSection>(section);
    EXPECT_EQ(message(), "velocity_x became nan at node (2, 3)" + end);
    snapshot.fields[0].values(4, 0) = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(message(), "water_depth became -inf at cell (4, 0)" + end);
    snapshot.bed(5, 0) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(message(), "the bed height became inf at cell (5, 0)" + end);
}

TEST(Pipeline, WhatFailsBeforeTheStartWritesNothing) {
    const ScratchFolder folder;
    Scene scene = parse_scene(small_scene(), "scene.toml", "");
    SpoiledModel model(1000);
    RunFolder run(folder / "out", false);
    Progress progress(Verbosity::quiet, 0);
    EXPECT_THROW(
        run_pipeline(model, scene, {}, outputs_in(run, scene), {}, progress,
                     [](const DrawingRecord&) { throw Error("the folder cannot be made"); }),
        Error);
    scene.view.look.palette = "no such palette";
    EXPECT_THROW(run_pipeline(model, scene, {}, outputs_in(run, scene), {}, progress,
                              [&](const DrawingRecord&) {
                                  run.create({true, false, true});
                              }),
                 InputError);
    EXPECT_FALSE(std::filesystem::exists(run.path()));
}

TEST(Pipeline, AFolderThatVanishesStopsTheRunOnce) {
    const ScratchFolder folder;
    const Scene scene = parse_scene(small_scene(), "scene.toml", "");
    SpoiledModel model(1000);
    RunFolder run(folder / "out", false);
    Progress progress(Verbosity::quiet, 0);
    const RunOutcome outcome = run_pipeline(model, scene, {}, outputs_in(run, scene), {}, progress,
                                            [](const DrawingRecord&) {});
    ASSERT_TRUE(outcome.error);
    EXPECT_NE(error_text(outcome.error).find("No such file or directory"), std::string::npos);
}

/// A flat bed that looks, between its steps, at the bytes that the program has allocated.
class HeapModel : public SpoiledModel {
  public:
    HeapModel() : SpoiledModel(-1) {}
    void step() override {
        SpoiledModel::step();
        constexpr std::int64_t often = 250;
        if (steps_done() % often != 0) return;
        // Until few frames are on their way: an encoder at work holds more than thousands of
        // records.
        std::this_thread::sleep_for(std::chrono::milliseconds(40));
        in_use[steps_done()] = mallinfo2().uordblks;
    }

    std::map<std::int64_t, std::size_t> in_use;
};

TEST(Pipeline, MemoryDoesNotGrowWithFrames) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers have a heap of their own";
#endif
    const ScratchFolder folder;
    constexpr std::int64_t steps = 6000;
    const Scene scene = parse_scene(
        "[model]\nname = \"static\"\n[grid]\nnx = 24\nny = 20\n[run]\nsteps = " +
            std::to_string(steps) +
            "\n[frames]\nevery = 1\n[image]\nwidth = 16\nheight = 16\nsupersampling = 1\n"
            "[output]\nmovie = false\n",
        "scene.toml", "");
    HeapModel model;
    RunFolder run(folder / "out", false);
    Progress progress(Verbosity::quiet, 0);
    const RunOutcome outcome = run_pipeline(model, scene, {}, outputs_in(run, scene), {}, progress,
                                            [&](const DrawingRecord&) {
                                                run.create({true, false, false});
                                            });
    ASSERT_FALSE(outcome.error) << error_text(outcome.error);
    ASSERT_EQ(outcome.frames, steps + 1);
    const auto looks = [&](std::int64_t from, std::int64_t to) {
        std::vector<double> bytes;
        for (auto at = model.in_use.lower_bound(from); at != model.in_use.upper_bound(to); ++at)
            bytes.push_back(static_cast<double>(at->second));
        std::ranges::sort(bytes);
        return bytes;
    };
    const std::vector<double> before = looks(1250, 3000);
    const std::vector<double> after = looks(4250, steps);
    ASSERT_EQ(before.size(), after.size());
    // Records raise the least, the median and the most; an encoder that is at work now and then
    // one of them, or none.
    std::array<double, 3> grown{};
    for (std::size_t i = 0; i < grown.size(); ++i) {
        const std::size_t at = i * (before.size() - 1) / 2;
        grown[i] = after[at] - before[at];
    }
    std::ranges::sort(grown);
    EXPECT_LT(grown[1], 20.0 * steps) << "bytes; a record of every frame would be 56 each";
}

TEST(BoundedQueue, GivesItemsInOrderAndEndsWhenClosed) {
    BoundedQueue<int> queue(4);
    EXPECT_TRUE(queue.push(1));
    EXPECT_TRUE(queue.push(2));
    queue.close();
    EXPECT_EQ(queue.pop(), 1);
    EXPECT_EQ(queue.pop(), 2);
    EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(BoundedQueue, AFullQueueHoldsTheProducerBack) {
    BoundedQueue<int> queue(1);
    std::atomic<int> pushed{0};
    std::jthread producer([&] {
        for (int item = 0; item < 3; ++item) {
            queue.push(item);
            ++pushed;
        }
        queue.close();
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(pushed, 1);
    for (int item = 0; item < 3; ++item) EXPECT_EQ(queue.pop(), item);
    EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(BoundedQueue, AbortWakesEveryoneAndDropsWhatIsLeft) {
    BoundedQueue<int> queue(1);
    queue.push(1);
    std::jthread producer([&] { EXPECT_FALSE(queue.push(2)); });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    queue.abort();
    producer.join();
    EXPECT_EQ(queue.pop(), std::nullopt);
}

}  // namespace
}  // namespace fumon::test
