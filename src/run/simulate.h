#pragma once

#include <atomic>

#include "run/parallel_runs.h"
#include "run/prepared_run.h"
#include "run/recorder.h"
#include "run/stepper.h"

namespace fumon {

/// Runs a model to the end of its scene without pictures and records what is due. `record` holds
/// the steps done so far and, as its message, "implausible: …" where the model warns of its state;
/// `cell_steps` grows with every step. Commits the records at the end. Returns
/// false if interrupted, having made no file; a run that fails keeps its measurements and throws.
/// `beside` follows the run's steps, too.
bool simulate(PreparedRun& prepared, Recorder& recorder, RunRecord& record,
              std::atomic<double>& cell_steps, StepObserver* beside = nullptr);

}  // namespace fumon
