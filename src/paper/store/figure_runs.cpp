#include "paper/store/figure_runs.h"

#include <utility>

namespace fumon {

std::size_t FigureRuns::add(StoredRun run) {
    const auto [known, is_new] = numbers_.emplace(run.id, runs_.size());
    if (is_new) {
        runs_.push_back(std::move(run));
    } else {
        runs_[known->second].steps.merge(run.steps);
    }
    return known->second;
}

}  // namespace fumon
