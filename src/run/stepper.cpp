#include "run/stepper.h"

#include <utility>

#include "base/cancellation.h"
#include "base/stopwatch.h"
#include "models/shared/check_finite.h"
#include "run/terminal/interrupt.h"

namespace fumon {

RunEnd at_step(std::int64_t last_step) {
    return [last_step](const Model& model) { return model.steps_done() >= last_step; };
}

Stepper::Stepper(Model& model, std::vector<StepObserver*> observers, bool present_taken)
    : model_(model), observers_(std::move(observers)), present_taken_(present_taken) {}

int Stepper::advance(const RunEnd& end) {
    try {
        return advance_until(end);
    } catch (const Cancelled&) {
        cancelled_ = true;
        return interrupting_signal();
    }
}

int Stepper::advance_until(const RunEnd& end) {
    for (;;) {
        publish_present_state();
        if (end(model_)) break;
        const int signal = interrupting_signal();
        for (StepObserver* observer : observers_) observer->before_step(model_, signal != 0);
        if (signal != 0) return signal;
        const Stopwatch watch;
        model_.step();
        seconds_ += watch.seconds();
        present_taken_ = false;
        for (StepObserver* observer : observers_) observer->after_step(model_);
    }
    check_finite(model_.snapshot());
    return 0;
}

void Stepper::publish_present_state() {
    if (std::exchange(present_taken_, true)) return;
    SharedSnapshot snapshot;
    for (StepObserver* observer : observers_) {
        if (!observer->wants(model_.steps_done())) continue;
        if (!snapshot) {
            snapshot = std::make_shared<const Snapshot>(model_.snapshot());
            check_finite(*snapshot);
        }
        observer->take(snapshot);
    }
}

}  // namespace fumon
