// Million cell-steps per second of the gully model on all processors, over grid sizes: water and
// bed together, at slope 0.04.

#include <benchmark/benchmark.h>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/water/gully.h"

namespace fumon {
namespace {

void measure(benchmark::State& state, WaterScheme scheme, SedimentTransport transport) {
    const int side = static_cast<int>(state.range(0));
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& z : bed.row(y)) z = 0.01 * stream.uniform();
    }
    GullyParameters parameters;
    parameters.scheme = scheme;
    parameters.transport = transport;
    WorkerPool pool;
    Gully gully(parameters, {bed, {}, {1.0, 1.0, 1.0, true}, 1, pool});
    for (int step = 0; step < 10; ++step) gully.step();
    for ([[maybe_unused]] auto _ : state) gully.step();
    state.counters["million_cell_steps_per_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(side) * side * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

void cip_incision(benchmark::State& state) {
    measure(state, WaterScheme::cip, SedimentTransport::incision);
}
void cip_as_printed(benchmark::State& state) {
    measure(state, WaterScheme::cip, SedimentTransport::as_printed);
}
void cip_fixed_bed(benchmark::State& state) {
    measure(state, WaterScheme::cip, SedimentTransport::none);
}
void as_published(benchmark::State& state) {
    measure(state, WaterScheme::cip_as_published, SedimentTransport::as_printed);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->RangeMultiplier(2)->Range(128, 2048)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(cip_incision)->Apply(sizes);
BENCHMARK(cip_as_printed)->Apply(sizes);
BENCHMARK(cip_fixed_bed)->Apply(sizes);
BENCHMARK(as_published)->Apply(sizes);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
