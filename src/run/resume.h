#pragma once

#include <memory>
#include <string>

#include "files/checkpoint.h"
#include "run/prepared_run.h"
#include "run/run_checkpoint.h"
#include "run/run_folder.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// A run taken up from its checkpoint: its model stands at the checkpoint's step.
struct ResumedRun {
    PreparedRun run;
    RunCheckpoint checkpoint;
    Snapshot first;  ///< before the run's first step
    /// What is left of the checkpoint: what the measures remember.
    std::unique_ptr<CheckpointReader> rest;
};

/// Takes up the run of a folder that was entered. Throws InputError, with nothing changed, for a
/// checkpoint that is damaged or of another version of fumon, where `asked` (or settings)
/// say another scene than the run's, where a file that the scene reads has changed, and where
/// frames that the checkpoint counts are gone.
ResumedRun resume_run(const RunFolder& folder, const std::string& asked,
                      const WorkOptions& options);

}  // namespace fumon
