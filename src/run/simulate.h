#pragma once

#include <atomic>
#include <cstdint>

#include "run/prepared_run.h"
#include "run/recorder.h"

namespace fumon {

/// Runs a model to its scene's end, recording what is due, without pictures. `steps` is how far it
/// has come, `cell_steps` grows with every step. False when interrupted, with no file made. Commits
/// the records; a run that fails keeps what it has measured and throws.
bool simulate(PreparedRun& prepared, Recorder& recorder, std::int64_t& steps,
              std::atomic<double>& cell_steps);

}  // namespace fumon
