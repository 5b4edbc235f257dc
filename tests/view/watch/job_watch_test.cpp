#include "run/terminal/job_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "support/viewed_run.h"
#include "view/subject/followed_subject.h"

namespace fumon {
namespace {

std::shared_ptr<const Snapshot> state_of_step(const Snapshot& first, std::int64_t step) {
    Snapshot snapshot = first;
    snapshot.step = step;
    snapshot.time = static_cast<double>(step);
    return std::make_shared<const Snapshot>(std::move(snapshot));
}

TEST(JobWatch, AsksForNothingUntilSomebodyWatches) {
    JobWatch watch;
    EXPECT_FALSE(watch.wants_picture());
    EXPECT_FALSE(watch.wants_snapshot());
    static_cast<void>(watch.state("a"));
    EXPECT_TRUE(watch.wants_picture());
    watch.show(std::make_shared<const Image>(2, 2), "frame 0");
    EXPECT_FALSE(watch.wants_picture());  // for some seconds
    EXPECT_EQ(watch.state("a").pictures, 1);
}

TEST(JobWatch, DrawsForWhoWatchesOneHundredthOfTheTime) {
    JobWatch watch;
    watch.ask_for_snapshot();
    EXPECT_TRUE(watch.wants_snapshot());
    watch.take(std::make_shared<const Snapshot>());
    EXPECT_FALSE(watch.wants_snapshot());
    watch.spend(0.02);  // for which two seconds pass, after one for the snapshot
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    watch.ask_for_snapshot();
    EXPECT_FALSE(watch.wants_snapshot());
    EXPECT_FALSE(watch.may_draw());
    std::this_thread::sleep_for(std::chrono::milliseconds(1800));
    watch.ask_for_snapshot();
    EXPECT_TRUE(watch.wants_snapshot());
}

TEST(JobWatch, ASnapshotThatComesLateEndsNoPause) {
    JobWatch watch;
    watch.ask_for_snapshot();
    watch.spend(10.0);  // a draft of the state before
    watch.take(std::make_shared<const Snapshot>());
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    EXPECT_FALSE(watch.may_draw());
}

TEST(JobWatch, EndsWhenAllWhoWatchHaveHeard) {
    JobWatch watch;
    const auto seconds_to_end = [&] {
        const auto begin = std::chrono::steady_clock::now();
        watch.end("complete");
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    EXPECT_LT(seconds_to_end(), 0.5);  // nobody
    JobWatch other;
    static_cast<void>(other.state("a"));
    static_cast<void>(other.state("b"));
    std::thread listens([&] {
        while (other.state("a").outcome.empty())
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        static_cast<void>(other.state("b", false));  // which has still to draw the end
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        static_cast<void>(other.state("b"));
    });
    const auto begin = std::chrono::steady_clock::now();
    other.end("complete");
    EXPECT_GT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(250));
    listens.join();
    EXPECT_EQ(other.state("b").outcome, "complete");
}

TEST(JobWatch, KeepsTheLastMessages) {
    JobWatch watch;
    for (int i = 0; i < 150; ++i) watch.message(std::to_string(i));
    const JobState state = watch.state("a");
    EXPECT_EQ(state.messages.size(), 100U);
    EXPECT_EQ(state.messages.back(), "149");
}

TEST(WatchedRun, ItsLastMomentIsTheNewestState) {
    const test::ScratchFolder folder;
    const auto run = viewed_run(folder.path());
    const auto scene = viewed_subject();
    const Snapshot& first = scene->first();
    JobWatch watch;
    const auto subject = watched_subject(run, scene->scene(), scene->inputs(), first, watch);
    EXPECT_EQ(subject->moments().back().step, 12);  // of its files
    EXPECT_TRUE(watch.wants_snapshot());
    watch.take(state_of_step(first, 8));  // older than a bed that is stored
    EXPECT_EQ(subject->moments().back().step, 12);
    watch.take(state_of_step(first, 15));
    const std::vector<ShownMoment> moments = subject->moments();
    EXPECT_EQ(moments.back().step, 15);
    EXPECT_EQ(subject->snapshot(moments.size() - 1)->step, 15);
    EXPECT_EQ(subject->snapshot(moments.size() - 2)->step, 12);
}

}  // namespace
}  // namespace fumon
