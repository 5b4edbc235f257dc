#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "base/snapshot.h"
#include "models/shared/model.h"

namespace fumon {

using SharedSnapshot = std::shared_ptr<const Snapshot>;

/// One that follows a run's steps: it records, draws, counts or saves. What its members throw ends
/// the run.
class StepObserver {
  public:
    StepObserver() = default;
    StepObserver(const StepObserver&) = delete;
    StepObserver& operator=(const StepObserver&) = delete;
    virtual ~StepObserver() = default;

    /// Whether it takes the snapshot of a step.
    [[nodiscard]] virtual bool wants(std::int64_t /*step*/) const { return false; }
    /// Takes the snapshot of a step that it wants.
    virtual void take(const SharedSnapshot& /*snapshot*/) {}
    /// Called before each further step, and once more where an interrupt comes instead of it.
    virtual void before_step(Model& /*model*/, bool /*interrupted*/) {}
    /// Called after each step, before the snapshot of it is taken.
    virtual void after_step(const Model& /*model*/) {}
    /// Called where no further step follows, also when one has failed: ends what it does while
    /// steps run. What that throws happened before whatever ended the run.
    virtual void settle() {}
};

/// Whether a run has come to its end, and makes no further step.
using RunEnd = std::function<bool(const Model&)>;

/// The end of a run at a step.
RunEnd at_step(std::int64_t last_step);

/// Steps a model from its present state, and calls its observers in their order:
///
///     the present state       take() of those that want it: one snapshot, finite, for all
///     the end, if it is that
///     before_step()
///     an interrupt, if there is one
///     the model's step
///     after_step()            and from the beginning
///
/// and at the end, however it came, settle().
class Stepper {
  public:
    /// `present_taken`: a former run has taken the present state's snapshots.
    Stepper(Model& model, std::vector<StepObserver*> observers, bool present_taken = false);

    /// Steps to the end, where the state must be finite. Returns 0, or the signal that stopped it
    /// before. May be called again to go on unless cancelled. Throws Error for a state that is not
    /// finite, and what model and observers throw.
    int advance(const RunEnd& end);

    /// Whether a signal stopped it within a step that had not ended `cancellation_grace_s` later
    /// (base/cancellation.h): the model counts that step as not done, but its state is no step's.
    [[nodiscard]] bool cancelled() const { return cancelled_; }

    /// Seconds inside the model's steps.
    [[nodiscard]] double seconds() const { return seconds_; }

  private:
    int advance_until(const RunEnd& end);
    void publish_present_state();
    void settle();

    Model& model_;
    std::vector<StepObserver*> observers_;
    bool present_taken_;
    bool present_is_finite_ = false;
    double seconds_ = 0.0;
    bool cancelled_ = false;
};

}  // namespace fumon
