#pragma once

#include <vector>

#include "base/snapshot.h"
#include "run/pipeline.h"
#include "run/run_folder.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// run.json: the scene as resolved, what stands in the folder, hashes and timings. It is written
/// twice, at the start (status "running") and when all is told (complete, interrupted, failed).
struct ManifestFacts {
    const Scene& scene;
    const InitialBed& initial;
    int threads = 0;
    RunFiles files{};                   ///< that the run may write
    std::vector<SnapshotWind> winds{};  ///< of a run that tells them
};

void write_running_manifest(const RunFolder& folder, const ManifestFacts& facts,
                            const DrawingRecord& drawing);
void write_final_manifest(const RunFolder& folder, const ManifestFacts& facts,
                          const RunOutcome& outcome);

/// The text of an error held by an exception pointer.
std::string error_text(const std::exception_ptr& error);

}  // namespace fumon
