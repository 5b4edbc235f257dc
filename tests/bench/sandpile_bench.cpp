// Million topplings per second of the sandpile on one processor, over grid sizes.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/pile/sandpile.h"

namespace fumon {
namespace {

/// A cone over the whole grid, about as steep as a pile grows by itself, with noise of 0 …
/// roughest.
Grid cone(int side, std::uint32_t roughest) {
    constexpr double steepness = 1.6;
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (int x = 0; x < side; ++x) {
            const double reach = 0.5 * side - std::hypot(x - side / 2, y - (side - 1 - side / 2));
            bed(x, y) = std::floor(std::max(0.0, steepness * reach)) + stream.below(roughest + 1);
        }
    }
    return bed;
}

void report(benchmark::State& state, std::int64_t topplings) {
    state.counters["million_topplings_per_second"] =
        benchmark::Counter(1e-6 * static_cast<double>(topplings), benchmark::Counter::kIsRate);
}

/// Grains on the tip of the cone, 1000 a step, after enough of them to bring large avalanches.
void drop(benchmark::State& state, const SandpileParameters& rules) {
    WorkerPool pool(1);
    SandpileParameters parameters = rules;
    parameters.grains_per_step = 1000;
    Sandpile pile(parameters, {cone(static_cast<int>(state.range(0)), 0), {}, {}, 1, pool});
    constexpr int steps_to_large_avalanches = 200;
    for (int step = 0; step < steps_to_large_avalanches; ++step) pile.step();
    std::int64_t topplings = 0;
    std::int64_t avalanches = 0;
    std::int64_t size = 0;
    std::int64_t largest = 0;
    for ([[maybe_unused]] auto _ : state) {
        pile.step();
        for (const Avalanche& one : pile.avalanches()) {
            topplings += one.topplings;
            size += one.size;
            largest = std::max(largest, one.size);
            ++avalanches;
        }
    }
    report(state, topplings);
    state.counters["mean_avalanche_size"] =
        static_cast<double>(size) / static_cast<double>(std::max<std::int64_t>(avalanches, 1));
    state.counters["largest_avalanche"] = static_cast<double>(largest);
}

/// Toppling all over the grid at once: a rough cone comes to rest.
void settle(benchmark::State& state) {
    constexpr std::uint32_t roughest = 8;
    const SandpileParameters parameters;
    const int side = static_cast<int>(state.range(0));
    const Grid bed = cone(side, roughest);
    const Site centre{side / 2, side - 1 - side / 2};
    std::int64_t topplings = 0;
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        Pile pile(parameters, bed, std::span<const Site>(&centre, 1));
        TopplingDraws draws(DropDirection::random, 1);
        state.ResumeTiming();
        topplings += pile.settle(draws);
    }
    report(state, topplings);
}

void published(benchmark::State& state) {
    drop(state, {});
}
void circular_mean(benchmark::State& state) {
    SandpileParameters rules;
    rules.direction = DirectionRule::circular_mean;
    drop(state, rules);
}
void first_in_first_out(benchmark::State& state) {
    SandpileParameters rules;
    rules.order = ToppleOrder::first_in_first_out;
    drop(state, rules);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(4)->Range(256, 4096)->Unit(benchmark::kMillisecond);
}

BENCHMARK(published)->Apply(sizes);
BENCHMARK(circular_mean)->Apply(sizes);
BENCHMARK(first_in_first_out)->Apply(sizes);
BENCHMARK(settle)->Apply(sizes);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
