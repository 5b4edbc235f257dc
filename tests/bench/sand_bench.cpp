// Million cell-steps per second of the wind-blown sand family on all processors, over grid sizes.

#include <benchmark/benchmark.h>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/sand/sand.h"

namespace fumon {
namespace {

Grid noise(int side, double low, double high) {
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = low + (high - low) * stream.uniform();
    }
    return bed;
}

SandParameters terada_ripples() {
    return {};
}

SandParameters terada_dunes() {
    SandParameters sand;
    sand.hop_length = HopLength::slope;
    sand.hop_amount = HopAmount::slope;
    sand.landing = Landing::truncate;
    return sand;
}

SandParameters terada_exponential() {
    SandParameters sand;
    sand.hop_length = HopLength::exponential;
    sand.creep_rate = 0.7;
    return sand;
}

SandParameters sudo(Creep creep) {
    SandParameters sand;
    sand.order = HopOrder::random_sequential;
    sand.hop_base = 3.0;
    sand.hop_per_height = 1.0;
    sand.landing = Landing::truncate;
    sand.limit_amount = false;
    sand.creep = creep;
    sand.creep_rate = 0.1;
    return sand;
}

void measure(benchmark::State& state, const SandParameters& parameters, double low, double high) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    Sand sand(parameters, {noise(side, low, high), {}, {}, 1, pool});
    constexpr int steps_to_a_pattern = 30;
    for (int step = 0; step < steps_to_a_pattern; ++step) sand.step();
    for ([[maybe_unused]] auto _ : state) sand.step();
    state.counters["million_cell_steps_per_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(side) * side * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

void ripples(benchmark::State& state) {
    measure(state, terada_ripples(), 0.0, 1.0);
}
void dunes(benchmark::State& state) {
    measure(state, terada_dunes(), 0.0, 1.0);
}
void exponential(benchmark::State& state) {
    measure(state, terada_exponential(), 0.0, 1.0);
}
void sudo_every_cell(benchmark::State& state) {
    measure(state, sudo(Creep::every_cell), 2.85, 3.15);
}
void sudo_maxima_only(benchmark::State& state) {
    measure(state, sudo(Creep::maxima_only), 2.85, 3.15);
}

/// One row of 10,000 to 4 million sites: Sudo's profile model.
void profile(benchmark::State& state) {
    const int sites = static_cast<int>(state.range(0));
    SandParameters parameters = sudo(Creep::profile);
    parameters.hop_base = 50.0;
    WorkerPool pool;
    Grid bed(sites, 1);
    RandomStream stream(1, 0, 0, Purpose::initial_bed);
    for (double& height : bed.values()) height = 48.5 + 3.0 * stream.uniform();
    Sand sand(parameters, {std::move(bed), {}, {}, 1, pool});
    constexpr int steps_to_a_pattern = 300;
    for (int step = 0; step < steps_to_a_pattern; ++step) sand.step();
    for ([[maybe_unused]] auto _ : state) sand.step();
    state.counters["million_cell_steps_per_second"] = benchmark::Counter(
        1e-6 * sites * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(2)->Range(128, 4096)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(ripples)->Apply(sizes);
BENCHMARK(dunes)->Apply(sizes);
BENCHMARK(exponential)->Apply(sizes);
BENCHMARK(sudo_every_cell)->Apply(sizes);
BENCHMARK(sudo_maxima_only)->Apply(sizes);
BENCHMARK(profile)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(4000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
