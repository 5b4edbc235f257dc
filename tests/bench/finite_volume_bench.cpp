// Million cell-steps per second of the finite-volume shallow water on all processors, over grid
// sizes; a cell-step is one cell advanced by one sub-step, both stages and its length included.

#include <benchmark/benchmark.h>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/water/finite_volume_scheme.h"

namespace fumon {
namespace {

Grid noise(int side, double height) {
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& z : bed.row(y)) z = height * stream.uniform();
    }
    return bed;
}

void measure(benchmark::State& state, double roughness, EdgeKind edges) {
    const int side = static_cast<int>(state.range(0));
    WorkerPool pool;
    WaterDomain domain;
    domain.slope = 0.04;
    domain.edges_x = domain.edges_y = edges;
    FiniteVolumeScheme scheme({}, domain, pool);
    Water water{Grid(side, side, 0.01), Grid(side, side), Grid(side, side, -0.6)};
    const Grid bed = noise(side, roughness);
    constexpr double rain = 1e-5;  // m/s
    constexpr double courant_number = 0.4;
    for ([[maybe_unused]] auto _ : state)
        scheme.advance(water, bed, courant_number * scheme.step_at_courant_one(water), rain);
    state.counters["million_cell_steps_per_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(side) * side * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

void film(benchmark::State& state) {
    measure(state, 0.001, EdgeKind::periodic);
}
void film_with_islands(benchmark::State& state) {
    measure(state, 0.1, EdgeKind::open);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(2)->Range(128, 2048)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(film)->Apply(sizes);
BENCHMARK(film_with_islands)->Apply(sizes);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
