#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "models/shared/check_finite.h"
#include "run/stepper.h"
#include "run/terminal/job_watch.h"
#include "run/terminal/progress.h"
#include "scene/schedule.h"

namespace fumon {

/// Hands on the snapshots of the steps of a schedule.
class ScheduledSnapshots : public StepObserver {
  public:
    using Receiver = std::function<void(const SharedSnapshot&)>;
    ScheduledSnapshots(Schedule schedule, Receiver receiver)
        : schedule_(std::move(schedule)), receiver_(std::move(receiver)) {}

    [[nodiscard]] bool wants(std::int64_t step) const override { return schedule_.due(step); }
    void take(const SharedSnapshot& snapshot) override { receiver_(snapshot); }

  private:
    Schedule schedule_;
    Receiver receiver_;
};

/// Tells a progress how many steps are done and how long they took; another thread shows it. It
/// comes last of the observers, whose work before a step is no part of that.
class StepCounter : public StepObserver {
  public:
    explicit StepCounter(Progress& progress) : progress_(progress) {}
    void before_step(Model& /*model*/, bool /*interrupted*/) override { watch_ = {}; }
    void after_step(const Model& model) override {
        progress_.seconds_of_steps += watch_.seconds();
        progress_.steps_done = model.steps_done();
    }

  private:
    Progress& progress_;
    Stopwatch watch_;
};

/// The same, and shows it.
class ProgressPrinter : public StepObserver {
  public:
    explicit ProgressPrinter(Progress& progress) : counted_(progress), progress_(progress) {}
    void before_step(Model& model, bool interrupted) override {
        counted_.before_step(model, interrupted);
    }
    void after_step(const Model& model) override {
        counted_.after_step(model);
        progress_.show();
    }

  private:
    StepCounter counted_;
    Progress& progress_;
};

/// Hands the state to those who watch a run, when they ask for it, and at the last step. It takes
/// no part in the run's own snapshots, which end the run where one is not finite: it goes as it
/// goes when nobody watches.
class WatchedState : public StepObserver {
  public:
    /// `watch` may be nullptr, as long as no run has this.
    WatchedState(JobWatch* watch, std::int64_t last_step) : watch_(watch), last_step_(last_step) {}

    void after_step(const Model& model) override {
        const bool last = model.steps_done() == last_step_ && watch_->has_clients();
        if (!last && !watch_->wants_snapshot()) return;
        auto snapshot = std::make_shared<const Snapshot>(model.snapshot());
        try {
            check_finite(*snapshot);
        } catch (const Error&) {
            return;  // the run tells it when it comes to it
        }
        watch_->take(std::move(snapshot));
    }

  private:
    JobWatch* watch_;
    std::int64_t last_step_;
};

/// Reports the first plausibility warning of a model's state.
class PlausibilityReporter : public StepObserver {
  public:
    using Receiver = std::function<void(const std::string&)>;
    explicit PlausibilityReporter(Receiver receiver) : receiver_(std::move(receiver)) {}
    void after_step(const Model& model) override {
        if (reported_) return;
        const std::string plausibility_warning = model.plausibility_warning();
        if (plausibility_warning.empty()) return;
        reported_ = true;
        receiver_(plausibility_warning);
    }

  private:
    Receiver receiver_;
    bool reported_ = false;
};

}  // namespace fumon
