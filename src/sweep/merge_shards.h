#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/parallel_runs.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// The numbers of the runs that a shard does, in their order. All shards share the runs out alike,
/// by their estimated length, whatever their folders hold.
std::vector<std::size_t> runs_of_shard(const SweepPlan& plan, const SweepFolder& folder, int shard,
                                       int shards);

/// Takes the runs that another folder of the same sweep has, and the folder not: what is done
/// before what has failed. Throws InputError where that folder holds no such sweep, or a program is
/// at work there.
void import_runs(const SweepPlan& plan, const SweepFolder& folder,
                 const std::filesystem::path& from);

/// The largest number of shards that the sweep.json of some folders list; 0 where none does.
int shards_in(const std::vector<std::filesystem::path>& folders);

/// What is missing of a sweep that `shards` programs share (0: not known): "shard 3 of 16 is
/// missing (2 of its 3 runs, from run 4)", a line each; none where all runs are done or have
/// failed. records[n - 1] is run n's.
std::vector<std::string> missing_shards(const SweepPlan& plan, const SweepFolder& folder,
                                        const std::vector<RunRecord>& records, int shards);

}  // namespace fumon
