#pragma once

#include <memory>
#include <string>

#include "files/checkpoint.h"
#include "run/prepared_run.h"
#include "run/run_checkpoint.h"
#include "run/run_folder.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// A run restored from its checkpoint; its model is at the checkpoint's step.
struct ResumedRun {
    PreparedRun run;
    RunCheckpoint checkpoint;
    Snapshot first;  ///< before the run's first step
    /// What is left of the checkpoint: what the measures remember.
    std::unique_ptr<CheckpointReader> rest;
    bool is_longer = false;  ///< a complete run goes on to a later step
    std::string note{};      ///< a line for the user, or nothing
};

/// Restores the run of a folder that was entered. One that is complete goes on to a later step,
/// where the settings change `run.steps` and nothing else. Throws InputError, with nothing changed,
/// if the checkpoint is damaged or of a fumon made from other sources, if `asked` (with its
/// settings) is not the run's scene, if a file that the scene reads has changed, or if a table,
/// bed, frame or the fields that the checkpoint counts are not there as the run wrote them.
ResumedRun resume_run(const RunFolder& folder, const std::string& asked,
                      const WorkOptions& options);

}  // namespace fumon
