// Million cell-steps per second of the dune model on all processors, and million picks per second
// of its slabs, from beds on which dunes and their slip faces have formed.

#include <benchmark/benchmark.h>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/dunes/dunes.h"

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

void measure(benchmark::State& state, const DunesParameters& parameters, double sand,
             int steps_to_a_pattern) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    Dunes dunes(parameters, {noise(side, 0.0, 2.0 * sand), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    for (int step = 0; step < steps_to_a_pattern; ++step) dunes.step();
    for ([[maybe_unused]] auto _ : state) dunes.step();
    state.counters["million_cell_steps_per_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(side) * side * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

/// Winds from west-southwest and west, so that lines of the shadow cross the grid aslant.
DunesParameters continuous(DuneSpeedUp speed_up, double from) {
    DunesParameters dunes;
    dunes.speed_up = speed_up;
    dunes.winds = {{from, 1.0, 1.0}};
    dunes.time_step = 0.001;
    return dunes;
}

void height(benchmark::State& state) {
    measure(state, continuous(DuneSpeedUp::height, 270.0), 1.0, 500);
}
void relief(benchmark::State& state) {
    measure(state, continuous(DuneSpeedUp::relief, 270.0), 1.0, 500);
}
void relief_aslant(benchmark::State& state) {
    measure(state, continuous(DuneSpeedUp::relief, 247.5), 1.0, 500);
}
void relief_with_barchans(benchmark::State& state) {
    measure(state, continuous(DuneSpeedUp::relief, 270.0), 1.0, 2500);
}

void slabs(benchmark::State& state) {
    DunesParameters dunes;
    dunes.transport = DuneTransport::slabs;
    dunes.speed_up = DuneSpeedUp::none;
    dunes.hop_length = 5.0;
    measure(state, dunes, 1.0, 100);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(height)->Apply(sizes);
BENCHMARK(relief)->Apply(sizes);
BENCHMARK(relief_aslant)->Apply(sizes);
BENCHMARK(relief_with_barchans)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(slabs)->Apply(sizes);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
