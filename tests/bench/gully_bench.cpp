// Million cell-steps per second of the gully model on all processors, over grid sizes: water and
// bed together, at slope 0.04; incision beside plain loops on one processor.

#include <benchmark/benchmark.h>

#include "base/random.h"
#include "base/worker_pool.h"
#include "fastest.h"
#include "models/water/gully.h"
#include "plain/gully_plain.h"

namespace fumon {
namespace {

constexpr int beside_plain_side = 512;

void measure(benchmark::State& state, WaterScheme scheme, SedimentTransport transport,
             bool has_plain = false) {
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
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state)
        state.SetIterationTime(fastest.time([&] { gully.step(); }));
    const double cells = static_cast<double>(side) * side;
    state.counters["million_cell_steps_per_second"] = fastest.rate(cells);
    if (!has_plain || side != beside_plain_side) return;
    // A step of fumon's after each plain one, so that both meet the same disturbances.
    plain::Gully plain(parameters, bed);
    Gully again(parameters, {bed, {}, {1.0, 1.0, 1.0, true}, 1, pool});
    Fastest plain_fastest;
    constexpr int steps = 40;
    for (int step = 0; step < steps; ++step) {
        plain_fastest.time([&] { plain.step(); });
        fastest.time([&] { again.step(); });
    }
    const Snapshot end = again.snapshot();
    if (end.bed != plain.bed() || end.fields.front().values != plain.depth())
        state.SkipWithError("the plain loops came to another end");
    state.counters["million_cell_steps_per_second"] = fastest.rate(cells);
    state.counters["plain"] = plain_fastest.rate(cells);
    state.counters["ratio_to_plain"] = fastest.rate(cells) / plain_fastest.rate(cells);
}

void cip_incision(benchmark::State& state) {
    measure(state, WaterScheme::cip, SedimentTransport::incision, true);
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
    one->RangeMultiplier(2)->Range(128, 4096)->Unit(benchmark::kMillisecond)->UseManualTime();
}

BENCHMARK(cip_incision)->Apply(sizes);
BENCHMARK(cip_as_printed)->Apply(sizes);
BENCHMARK(cip_fixed_bed)->Apply(sizes);
BENCHMARK(as_published)->Apply(sizes);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
