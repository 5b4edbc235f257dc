// Million grain-steps per second of grain flights on two threads, by drag law.

#include <benchmark/benchmark.h>

#include <cmath>

#include "base/worker_pool.h"
#include "models/air/grain_flight.h"
#include "support/couette_section.h"

namespace fumon {
namespace {

/// Table 3 of Terada (2025): 1200 × 60 nodes over one wave of 0.5 mm, four angles.
void fly(benchmark::State& state, GrainDrag drag) {
    constexpr double spacing = 0.025e-3;
    const SnapshotSection section = test::couette_section(1200, 60, spacing, 1.0, [](double x) {
        return 0.25e-3 * (1.0 + std::cos(2.0 * 3.14159265358979 * x / (1200 * spacing)));
    });
    WorkerPool pool(2);
    FlightParameters parameters;
    parameters.drag = drag;
    const GrainFlights flights(section, parameters, {}, pool);
    const std::vector<Launch> launches = flights.every_column(parameters.launch_angles);
    double steps = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        for (const Flight& flight : flights.fly(launches))
            steps += flight.time / parameters.flight_time_step;
    }
    state.counters["million_grain_steps_per_second"] =
        benchmark::Counter(1e-6 * steps, benchmark::Counter::kIsRate);
}

void stokes(benchmark::State& state) {
    fly(state, GrainDrag::stokes);
}
void schiller_naumann(benchmark::State& state) {
    fly(state, GrainDrag::schiller_naumann);
}

BENCHMARK(stokes)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(schiller_naumann)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
