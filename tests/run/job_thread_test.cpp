#include "run/job_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "base/error.h"

namespace fumon::test {
namespace {

TEST(JobThread, DoesJobsInTheirOrderOnAThreadOfItsOwn) {
    std::string log;
    std::thread::id there;
    JobThread thread("fumon-test");
    thread.wait();
    for (const char letter : {'a', 'b', 'c'}) {
        thread.hand_over([&log, &there, letter] {
            log += letter;
            there = std::this_thread::get_id();
        });
    }
    thread.wait();
    EXPECT_EQ(log, "abc");
    EXPECT_NE(there, std::this_thread::get_id());
}

TEST(JobThread, TheOneThatHandsOverGoesOnUntilTheNextJob) {
    std::promise<void> go;
    bool done = false;
    JobThread thread("fumon-test");
    thread.hand_over([&done, may_go = go.get_future().share()] {
        done = may_go.wait_for(std::chrono::seconds(10)) == std::future_status::ready;
    });
    go.set_value();  // too late where the job is waited for
    bool done_before = false;
    thread.hand_over([&] { done_before = done; });
    EXPECT_TRUE(done);
    thread.wait();
    EXPECT_TRUE(done_before);
}

TEST(JobThread, WhatAJobHeldIsGoneWhenItIsDone) {
    auto held = std::make_shared<int>(3);
    const std::weak_ptr<int> seen = held;
    JobThread thread("fumon-test");
    thread.hand_over([held = std::move(held)] { static_cast<void>(*held); });
    thread.wait();
    EXPECT_TRUE(seen.expired());
}

TEST(JobThread, AfterAJobThatThrowsNoneIsDoneAndAllHear) {
    JobThread thread("fumon-test");
    bool later = false;
    thread.hand_over([] { throw Error("full"); });
    EXPECT_THROW(thread.hand_over([&] { later = true; }), Error);
    EXPECT_THROW(thread.wait(), Error);
    EXPECT_NE(thread.failure(), nullptr);
    EXPECT_FALSE(later);
}

TEST(JobThread, EndsAfterTheJobUnderWay) {
    bool done = false;
    {
        JobThread thread("fumon-test");
        thread.hand_over([&done] { done = true; });
    }
    EXPECT_TRUE(done);
    const JobThread unused("fumon-test");
}

}  // namespace
}  // namespace fumon::test
