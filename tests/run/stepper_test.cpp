#include "run/stepper.h"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <string>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/state_archive.h"
#include "run/terminal/interrupt.h"

namespace fumon::test {
namespace {

/// A bed that counts its steps, how often it was copied, and turns NaN at a step.
class CountingModel : public Model {
  public:
    [[nodiscard]] std::string_view name() const override { return "counting"; }
    void step() override {
        if (steps_ == given_up_at) {
            std::raise(SIGTERM);
            throw Cancelled();
        }
        if (++steps_ == spoiled_at) bed_(1, 1) = std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] std::int64_t steps_done() const override { return steps_; }
    [[nodiscard]] Snapshot snapshot() const override {
        ++snapshots;
        return {steps_, static_cast<double>(steps_), "steps", bed_, {}, {}};
    }
    [[nodiscard]] std::vector<StateField> state() const override { return {}; }
    void serialise(StateArchive& archive) override { archive.count("steps", steps_); }

    std::int64_t spoiled_at = -1;
    std::int64_t given_up_at = -1;
    mutable int snapshots = 0;

  private:
    std::int64_t steps_ = 0;
    Grid bed_{4, 3, 1.0};
};

/// Writes down what it is called for: "a2" takes the snapshot of step 2, "a+2" follows step 2,
/// "a>2" stands before the step after 2, "a!2" is stopped there.
class Witness : public StepObserver {
  public:
    Witness(std::string name, std::int64_t every, std::string& log)
        : name_(std::move(name)), every_(every), log_(log) {}
    [[nodiscard]] bool wants(std::int64_t step) const override { return step % every_ == 0; }
    void take(const SharedSnapshot& snapshot) override {
        last = snapshot;
        write("", snapshot->step);
    }
    void before_step(Model& model, bool interrupted) override {
        write(interrupted ? "!" : ">", model.steps_done());
    }
    void after_step(const Model& model) override { write("+", model.steps_done()); }

    SharedSnapshot last;

  private:
    void write(const std::string& what, std::int64_t step) {
        log_ += name_ + what + std::to_string(step) + " ";
    }

    std::string name_;
    std::int64_t every_;
    std::string& log_;
};

TEST(Stepper, CallsObserversInTheirOrderWithOneSnapshotForAll) {
    CountingModel model;
    std::string log;
    Witness a("a", 2, log);
    Witness b("b", 1, log);
    Stepper stepper(model, {&a, &b});
    EXPECT_EQ(stepper.advance(at_step(2)), 0);
    EXPECT_EQ(log, "a0 b0 a>0 b>0 a+1 b+1 b1 a>1 b>1 a+2 b+2 a2 b2 ");
    EXPECT_EQ(a.last, b.last) << "the same snapshot, not its equal";
    EXPECT_EQ(model.snapshots, 3) << "the end is looked at in that of its step";
    log.clear();
    EXPECT_EQ(stepper.advance(at_step(3)), 0) << "goes on, and takes nothing twice";
    EXPECT_EQ(log, "a>2 b>2 a+3 b+3 b3 ");
}

TEST(Stepper, TakesNothingThatAFormerRunHasTaken) {
    CountingModel model;
    std::string log;
    Witness a("a", 1, log);
    EXPECT_EQ(Stepper(model, {&a}, true).advance(at_step(1)), 0);
    EXPECT_EQ(log, "a>0 a+1 a1 ");
}

TEST(Stepper, AnInterruptComesAfterTheSnapshotAndInsteadOfTheStep) {
    const InterruptGuard guard;
    CountingModel model;
    std::string log;
    Witness a("a", 1, log);
    Stepper stepper(model, {&a});
    std::raise(SIGTERM);
    EXPECT_EQ(stepper.advance(at_step(5)), SIGTERM);
    EXPECT_EQ(log, "a0 a!0 ");
    EXPECT_EQ(stepper.advance(at_step(0)), 0) << "the end comes before an interrupt";
    clear_interrupt();
    EXPECT_EQ(exit_status_of_signal(SIGTERM), 143);
}

TEST(Stepper, AStepThatIsGivenUpIsShownToNobody) {
    const InterruptGuard guard;
    CountingModel model;
    model.given_up_at = 2;
    std::string log;
    Witness a("a", 1, log);
    Stepper stepper(model, {&a});
    EXPECT_FALSE(stepper.cancelled());
    EXPECT_EQ(stepper.advance(at_step(5)), SIGTERM);
    EXPECT_TRUE(stepper.cancelled());
    EXPECT_EQ(log, "a0 a>0 a+1 a1 a>1 a+2 a2 a>2 ") << "no checkpoint, no snapshot";
    EXPECT_EQ(model.snapshots, 3);
    EXPECT_GT(stop_requested_at_ns, 0);
    clear_interrupt();
    EXPECT_EQ(stop_requested_at_ns, 0);
}

TEST(Stepper, AStateThatIsNotFiniteIsSeenByNoObserver) {
    CountingModel model;
    model.spoiled_at = 3;
    std::string log;
    Witness a("a", 4, log);
    EXPECT_THROW(Stepper(model, {&a}).advance(at_step(9)), Error);
    EXPECT_EQ(model.steps_done(), 4);
    EXPECT_EQ(log.find("a4"), std::string::npos) << log;
    CountingModel unseen;
    unseen.spoiled_at = 3;
    EXPECT_THROW(Stepper(unseen, {}).advance(at_step(9)), Error) << "the end is looked at";
}

/// Fails in the background from a step on, and says so when it settles.
class Failing : public StepObserver {
  public:
    [[nodiscard]] bool wants(std::int64_t /*step*/) const override { return true; }
    void settle() override {
        ++settled;
        if (fails) throw Error("the record before");
    }
    bool fails = false;
    int settled = 0;
};

TEST(Stepper, ObserversSettleHoweverTheStepsEnd) {
    const InterruptGuard guard;
    Failing observer;
    CountingModel model;
    Stepper stepper(model, {&observer});
    stepper.advance(at_step(2));
    EXPECT_EQ(observer.settled, 1);
    model.given_up_at = 2;
    stepper.advance(at_step(3));
    EXPECT_TRUE(stepper.cancelled());
    EXPECT_EQ(observer.settled, 2);
    clear_interrupt();
    CountingModel spoiled;
    spoiled.spoiled_at = 1;
    EXPECT_THROW(Stepper(spoiled, {&observer}).advance(at_step(2)), Error);
    EXPECT_EQ(observer.settled, 3);
}

TEST(Stepper, WhatFailedBeforeTheStepThatFailedIsTold) {
    Failing observer;
    observer.fails = true;
    CountingModel spoiled;
    spoiled.spoiled_at = 1;
    try {
        Stepper(spoiled, {&observer}).advance(at_step(2));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the record before");
    }
    CountingModel model;
    EXPECT_THROW(Stepper(model, {&observer}).advance(at_step(1)), Error);
}

}  // namespace
}  // namespace fumon::test
