// Million node-steps per second of the air over a bed, on one processor and on two; tables 2 and C1
// beside plain loops on one, which solve the pressures by factors of their equations or as fumon
// does.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/worker_pool.h"
#include "fastest.h"
#include "models/air/air_plane.h"
#include "models/air/airflow.h"
#include "plain/air_plain.h"

namespace fumon {
namespace {

struct Box {
    int nx;
    int nz;
    double spacing;
    double time_step;
};

/// The largest difference of the velocities, as a part of the lid's speed.
double difference(const Airflow& model, const plain::Air& plain, double lid_speed) {
    const std::vector<StateField> fields = model.state();
    double most = 0.0;
    for (std::size_t node = 0; node < plain.u().size(); ++node) {
        most = std::max({most, std::fabs(fields[0].values[node] - plain.u()[node]),
                         std::fabs(fields[1].values[node] - plain.w()[node])});
    }
    return most / lid_speed;
}

void advance(benchmark::State& state, const Box& box, AirSchemeKind scheme, bool has_plain) {
    WorkerPool pool(static_cast<int>(state.range(0)));
    AirflowParameters parameters;
    parameters.scheme = scheme;
    parameters.nz = box.nz;
    parameters.time_step = box.time_step;
    const ModelSetup setup{Grid(box.nx, 1), {}, {box.spacing, box.spacing, 1.0, true}, 1, pool};
    Airflow model(parameters, setup);
    const int together = 100'000 / (box.nx * box.nz) + 1;  // steps: one alone may be too short
    const double nodes = static_cast<double>(box.nx) * box.nz * together;
    const auto advanced = [together](auto& some) {
        return [&some, together] {
            for (int step = 0; step < together; ++step) some.step();
        };
    };
    Fastest fastest;
    for ([[maybe_unused]] auto _ : state) state.SetIterationTime(fastest.time(advanced(model)));
    state.counters["million_node_steps_per_second"] = fastest.rate(nodes);
    if (!has_plain) return;
    const AirPlane plane = make_air_plane(parameters, setup);
    for (const auto& [name, pressures] :
         {std::pair("plain", plain::Pressures::by_factors),
          std::pair("plain_by_fourier", plain::Pressures::by_fourier)}) {
        plain::Air plain(plane, parameters, pressures);
        Airflow again(parameters, setup);
        Fastest plain_fastest;
        constexpr int times = 20;
        for (int time = 0; time < times; ++time) {
            plain_fastest.time(advanced(plain));
            fastest.time(advanced(again));
        }
        constexpr double rounding = 1e-12;
        if (!(difference(again, plain, parameters.lid_speed) < rounding))
            state.SkipWithError("the plain loops came to another end");
        state.counters[name] = plain_fastest.rate(nodes);
        state.counters[std::string("ratio_to_") + name] =
            fastest.rate(nodes) / plain_fastest.rate(nodes);
    }
    state.counters["million_node_steps_per_second"] = fastest.rate(nodes);
}

void table_2(benchmark::State& state) {
    advance(state, {100, 30, 5e-5, 5e-6}, AirSchemeKind::staircase, true);
}
void table_3(benchmark::State& state) {
    advance(state, {1200, 60, 2.5e-5, 2.5e-6}, AirSchemeKind::staircase, false);
}
void table_c1(benchmark::State& state) {
    advance(state, {500, 150, 1e-5, 1e-6}, AirSchemeKind::staircase, true);
}
void fitted_table_2(benchmark::State& state) {
    advance(state, {100, 30, 5e-5, 5e-6}, AirSchemeKind::boundary_fitted, false);
}

BENCHMARK(table_2)->Arg(1)->Arg(2)->UseManualTime();
BENCHMARK(table_3)->Arg(1)->Arg(2)->UseManualTime();
BENCHMARK(table_c1)->Arg(1)->Arg(2)->UseManualTime();
BENCHMARK(fitted_table_2)->Arg(1)->UseManualTime();

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
