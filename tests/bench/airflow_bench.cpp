// Million node-steps per second of the air over a bed, on one processor and on two.

#include <benchmark/benchmark.h>

#include "base/worker_pool.h"
#include "models/air/airflow.h"

namespace fumon {
namespace {

struct Box {
    int nx;
    int nz;
    double spacing;
    double time_step;
};

void advance(benchmark::State& state, const Box& box, AirSchemeKind scheme) {
    WorkerPool pool(static_cast<int>(state.range(0)));
    AirflowParameters parameters;
    parameters.scheme = scheme;
    parameters.nz = box.nz;
    parameters.time_step = box.time_step;
    Airflow model(parameters,
                  {Grid(box.nx, 1), {}, {box.spacing, box.spacing, 1.0, true}, 1, pool});
    for ([[maybe_unused]] auto _ : state) model.step();
    state.counters["million_node_steps_per_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(box.nx) * box.nz * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

void table_2(benchmark::State& state) {
    advance(state, {100, 30, 5e-5, 5e-6}, AirSchemeKind::staircase);
}
void table_3(benchmark::State& state) {
    advance(state, {1200, 60, 2.5e-5, 2.5e-6}, AirSchemeKind::staircase);
}
void table_c1(benchmark::State& state) {
    advance(state, {500, 150, 1e-5, 1e-6}, AirSchemeKind::staircase);
}
void fitted_table_2(benchmark::State& state) {
    advance(state, {100, 30, 5e-5, 5e-6}, AirSchemeKind::boundary_fitted);
}

BENCHMARK(table_2)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(table_3)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(table_c1)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(fitted_table_2)->Arg(1)->UseRealTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
