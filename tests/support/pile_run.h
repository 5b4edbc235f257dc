#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/pile/sandpile.h"

namespace fumon {

inline SandpileParameters cycling() {
    SandpileParameters pile;
    pile.drop_direction = DropDirection::cycling;
    return pile;
}

/// A model, its pool and all its avalanches.
struct PileRun {
    WorkerPool pool{1};
    Sandpile model;
    std::vector<Avalanche> avalanches;

    PileRun(const SandpileParameters& parameters, Grid bed, std::uint64_t seed = 1)
        : model(parameters, {std::move(bed), {}, {}, seed, pool}) {}

    void step(int steps) {
        for (int done = 0; done < steps; ++done) {
            model.step();
            for (const Avalanche& one : model.avalanches()) avalanches.push_back(one);
        }
    }
    [[nodiscard]] std::int64_t topplings() const {
        std::int64_t sum = 0;
        for (const Avalanche& one : avalanches) sum += one.topplings;
        return sum;
    }
};

inline Grid flat(int nx, int ny) {
    return {nx, ny, 0.0};
}

/// Whole heights 0 … highest.
inline Grid rough(int nx, int ny, std::uint32_t highest, std::uint64_t seed) {
    Grid bed(nx, ny);
    RandomStream stream(seed, 0, 0, Purpose::initial_bed);
    for (double& height : bed.values()) height = stream.below(highest + 1);
    return bed;
}

inline double total(const Grid& bed) {
    return std::accumulate(bed.values().begin(), bed.values().end(), 0.0);
}

/// Names a case that failed.
inline std::string text(const SandpileParameters& pile) {
    return "direction " + std::to_string(static_cast<int>(pile.direction)) + ", toward " +
           std::to_string(static_cast<int>(pile.topple_toward)) + ", order " +
           std::to_string(static_cast<int>(pile.order)) + ", T " + std::to_string(pile.threshold) +
           ", g " + std::to_string(pile.grains_per_topple);
}

inline std::vector<SandpileParameters> all_rules() {
    std::vector<SandpileParameters> all;
    for (const auto& [threshold, grains] : std::vector<std::pair<int, int>>{
             {5, 3}, {4, 3}, {3, 2}, {2, 1}, {4, 2}, {6, 4}, {7, 5}, {10, 7}}) {
        for (const DirectionRule rule :
             {DirectionRule::mean, DirectionRule::mean_rounded, DirectionRule::circular_mean}) {
            for (const ToppleToward toward :
                 {ToppleToward::any_lower, ToppleToward::toward_direction}) {
                for (const ToppleOrder order :
                     {ToppleOrder::sweep, ToppleOrder::first_in_first_out}) {
                    SandpileParameters pile;
                    pile.threshold = threshold;
                    pile.grains_per_topple = grains;
                    pile.direction = rule;
                    pile.topple_toward = toward;
                    pile.order = order;
                    all.push_back(pile);
                }
            }
        }
    }
    return all;
}

/// With one grain per topple the published direction mean lets grains go round for ever on a rough
/// bed; see Sandpile.SaysWhenGrainsGoRoundForEver.
inline bool may_never_rest(const SandpileParameters& pile) {
    return pile.grains_per_topple == 1 && pile.direction == DirectionRule::mean &&
           pile.topple_toward == ToppleToward::any_lower;
}

}  // namespace fumon
