#include "run/simulate.h"

#include "run/check_finite.h"
#include "run/interrupt.h"

namespace fumon {

namespace {

/// False when it was interrupted.
bool advance(Workshop& workshop, Recorder& recorder, std::int64_t& steps,
             std::atomic<double>& cell_steps) {
    Model& model = *workshop.model;
    const auto cells = static_cast<double>(workshop.initial.bed.size());
    for (;;) {
        steps = model.steps_done();
        if (recorder.due(steps)) {
            const Snapshot snapshot = model.snapshot();
            check_finite(snapshot);
            recorder.record(snapshot);
        }
        if (steps >= workshop.scene.run.steps) break;
        if (interrupting_signal() != 0) return false;
        model.step();
        recorder.note(model.avalanches());
        cell_steps += cells;
    }
    check_finite(model.snapshot());
    return true;
}

/// What a failing run has measured before is kept where it can be.
void keep(Recorder& recorder) {
    try {
        recorder.commit();
    } catch (const std::exception&) {
        return;  // the run's own fault is what is told
    }
}

}  // namespace

bool simulate(Workshop& workshop, Recorder& recorder, std::int64_t& steps,
              std::atomic<double>& cell_steps) {
    try {
        if (!advance(workshop, recorder, steps, cell_steps)) return false;
    } catch (...) {
        keep(recorder);
        throw;
    }
    recorder.commit();
    return true;
}

}  // namespace fumon
