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
    int signal = 0;
    try {
        signal = advance_until(end);
    } catch (const Cancelled&) {
        cancelled_ = true;
        signal = interrupting_signal();
    } catch (...) {
        settle();
        throw;
    }
    settle();
    return signal;
}

void Stepper::settle() {
    for (StepObserver* observer : observers_) observer->settle();
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
        present_is_finite_ = false;
        for (StepObserver* observer : observers_) observer->after_step(model_);
    }
    if (!std::exchange(present_is_finite_, true)) check_finite(model_.snapshot());
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
            present_is_finite_ = true;
        }
        observer->take(snapshot);
    }
}

}  // namespace fumon
