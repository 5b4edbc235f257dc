#pragma once

#include <functional>
#include <string>
#include <utility>

#include "run/stepper.h"
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

/// Tells a progress how many steps are done; another thread shows it.
class CountedSteps : public StepObserver {
  public:
    explicit CountedSteps(Progress& progress) : progress_(progress) {}
    void after_step(const Model& model) override { progress_.steps_done = model.steps_done(); }

  private:
    Progress& progress_;
};

/// The same, and shows it.
class ShownSteps : public StepObserver {
  public:
    explicit ShownSteps(Progress& progress) : progress_(progress) {}
    void after_step(const Model& model) override {
        progress_.steps_done = model.steps_done();
        progress_.show();
    }

  private:
    Progress& progress_;
};

/// Tells the first doubt that a model has of its state.
class ToldDoubt : public StepObserver {
  public:
    using Receiver = std::function<void(const std::string&)>;
    explicit ToldDoubt(Receiver receiver) : receiver_(std::move(receiver)) {}
    void after_step(const Model& model) override {
        if (told_) return;
        const std::string doubt = model.doubt();
        if (doubt.empty()) return;
        told_ = true;
        receiver_(doubt);
    }

  private:
    Receiver receiver_;
    bool told_ = false;
};

}  // namespace fumon
