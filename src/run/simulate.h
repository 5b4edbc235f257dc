#pragma once

#include <atomic>
#include <cstdint>

#include "run/prepared_run.h"
#include "run/recorder.h"

namespace fumon {

/// Runs a model to the end of its scene without pictures and records what is due. `steps` holds the
/// steps done so far; `cell_steps` grows with every step. Commits the records at the end. Returns
/// false if interrupted, having made no file; a run that fails keeps its measurements and throws.
bool simulate(PreparedRun& prepared, Recorder& recorder, std::int64_t& steps,
              std::atomic<double>& cell_steps);

}  // namespace fumon
