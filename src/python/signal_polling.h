#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>

#include "base/stopwatch.h"
#include "run/stepper.h"

namespace fumon::python {

/// How often Python is asked for what came in while C++ works, a Ctrl-C above all.
inline constexpr std::chrono::milliseconds signal_poll_interval{50};

/// Lets Python handle its signals. Throws pybind11::error_already_set where a handler raises, as
/// that of Ctrl-C raises KeyboardInterrupt. The caller does not hold the interpreter's lock.
inline void check_signals() {
    const pybind11::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

/// Looks for signals between the steps of a run.
class SignalObserver : public StepObserver {
  public:
    void before_step(Model& /*model*/, bool /*interrupted*/) override {
        if (watch_.seconds() < std::chrono::duration<double>(signal_poll_interval).count()) return;
        watch_ = {};
        check_signals();
    }

  private:
    Stopwatch watch_;
};

/// Waits for a value that another thread makes, looking for signals; the caller does not hold the
/// interpreter's lock. Throws what the other thread threw, and as check_signals().
template <class Value>
Value wait_for(std::future<Value> future) {
    while (future.wait_for(signal_poll_interval) != std::future_status::ready) check_signals();
    return future.get();
}

}  // namespace fumon::python
