#include "sweep/merge_shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "files/folder_lock.h"
#include "files/input_file.h"
#include "shards/shard.h"
#include "sweep/sweep_manifest.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// For each run of the plan, whose it is.
std::vector<int> shares_of_runs(const SweepPlan& plan, int shards) {
    std::vector<double> lengths;
    lengths.reserve(plan.runs.size());
    for (const SweepRun& run : plan.runs) lengths.push_back(run.work);
    return shares_of(lengths, shards);
}

std::string run_count(std::size_t count) {
    return fmt::format("{} {}", count, count == 1 ? "run" : "runs");
}

}  // namespace

std::vector<std::size_t> runs_of_shard(const SweepPlan& plan, const SweepFolder& folder, int shard,
                                       int shards) {
    const std::vector<int> shares = shares_of_runs(plan, shards);
    std::vector<std::size_t> numbers;
    for (std::size_t number = 1; number <= plan.runs.size(); ++number) {
        if (shares[folder.order()[number - 1]] == shard) numbers.push_back(number);
    }
    return numbers;
}

void import_runs(const SweepPlan& plan, const SweepFolder& folder, const fs::path& from) {
    std::error_code fault;
    if (fs::equivalent(from, folder.table().parent_path(), fault)) return;
    const fs::path manifest = from / "sweep.json";
    if (!fs::is_regular_file(manifest, fault)) {
        throw InputError(
            fmt::format("--from {}: holds no sweep (no sweep.json); name the folder of a "
                        "shard",
                        from.string()));
    }
    const FolderLock lock(from);
    const PreviousSweep previous = previous_sweep(read_input_file(manifest), plan);
    if (!previous.differs.empty())
        throw InputError(fmt::format("--from {}: {}", from.string(), previous.differs));
    std::vector<std::size_t> number_of(plan.runs.size());
    for (std::size_t number = 1; number <= folder.order().size(); ++number)
        number_of[folder.order()[number - 1]] = number;
    for (std::size_t there = 1; there <= previous.order.size(); ++there) {
        const SweepRun& run = plan.runs[previous.order[there - 1]];
        const fs::path text = from / "runs" / fmt::format("{:04}.json", there);
        if (!fs::exists(text, fault)) continue;
        const RunStatus status = parse_run_record(read_input_file(text), run.id).status;
        const std::size_t number = number_of[previous.order[there - 1]];
        const RunStatus here = folder.read_record(number).status;
        const bool is_news = status == RunStatus::done
                                 ? here != RunStatus::done
                                 : status == RunStatus::failed && here == RunStatus::pending;
        if (is_news) folder.import_run(number, from, there);
    }
}

int shards_in(const std::vector<fs::path>& folders) {
    int shards = 0;
    for (const fs::path& folder : folders) {
        std::error_code fault;
        const fs::path manifest = folder / "sweep.json";
        if (fs::is_regular_file(manifest, fault))
            shards = std::max(shards, listed_shards(read_input_file(manifest)));
    }
    return shards;
}

std::vector<std::string> missing_shards(const SweepPlan& plan, const SweepFolder& folder,
                                        const std::vector<RunRecord>& records, int shards) {
    const int parts = std::max(1, shards);
    std::vector<std::string> missing;
    for (int shard = 1; shard <= parts; ++shard) {
        const std::vector<std::size_t> numbers = runs_of_shard(plan, folder, shard, parts);
        std::vector<std::size_t> pending;
        std::ranges::copy_if(numbers, std::back_inserter(pending), [&](std::size_t number) {
            return records[number - 1].status == RunStatus::pending;
        });
        if (pending.empty()) continue;
        const std::string runs =
            pending.size() == numbers.size()
                ? fmt::format("its {}, from run {} on", run_count(numbers.size()), pending.front())
                : fmt::format("{} of its {}, from run {} on", pending.size(),
                              run_count(numbers.size()), pending.front());
        missing.push_back(shards > 0
                              ? fmt::format("shard {}/{} is missing: {}", shard, shards, runs)
                              : fmt::format("{} of {} are missing, from run {} on", pending.size(),
                                            run_count(numbers.size()), pending.front()));
    }
    return missing;
}

}  // namespace fumon
