#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/hash.h"
#include "run/parallel_runs.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// sweep.json of a plan whose runs stand in this order. `shards`: how many programs share them; 0:
/// one does them all.
std::string sweep_manifest(const SweepPlan& plan, const std::vector<std::size_t>& order,
                           int shards = 0);

/// How many runs the sweep of a sweep.json's text has; −1 where it is no manifest of fumon's.
std::int64_t listed_runs(std::string_view manifest);

/// How many shards share the sweep of a sweep.json's text; 0 where one program does it all.
int listed_shards(std::string_view manifest);

/// What a former sweep in a plan's folder means for its runs.
struct PreviousSweep {
    std::vector<std::size_t> order;  ///< the plan's runs that it has, in the order of their numbers
    /// Why the sweep is no part of the plan, as "holds another sweep: its scene has run.steps = 20,
    /// now 40" or "holds a sweep whose sweep.json is damaged"; empty where it is one.
    std::string differs;
};

/// Reads the text of that sweep's sweep.json.
PreviousSweep previous_sweep(std::string_view manifest, const SweepPlan& plan);

/// The text of the record of a run that is done or has failed, and back; what is none of this run,
/// or is damaged, gives a pending one.
std::string run_record_text(const Sha256& id, const RunRecord& record);
RunRecord parse_run_record(std::string_view text, const Sha256& id);

}  // namespace fumon
