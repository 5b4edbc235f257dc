// What records of measurements cost: processor time a cell of one row, by landform; and runs with a
// row every step beside the same runs with one at their end, as ratios of processor time and of
// clock time. And what steps of dunes cost: processor time a cell by the grid's size, and one
// thread beside two.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/stopwatch.h"
#include "base/thread_clock.h"
#include "files/scratch_folder.h"
#include "measure/suite.h"
#include "models/shared/model.h"
#include "run/prepared_run.h"
#include "run/recorder.h"
#include "run/stepper.h"
#include "scene/read.h"

namespace fumon {
namespace {

constexpr const char* ripples =
    "[model]\nname = \"sand\"\norder = \"synchronous\"\nhop_length = \"linear\"\nhop_base = 5.0\n"
    "hop_per_height = 2.0\nlanding = \"round\"\nhop_amount = \"constant\"\namount = 0.1\n"
    "creep = \"every-cell\"\ncreep_rate = 0.15\n[bed]\nkind = \"noise\"\nhigh = 1.0\n";
constexpr const char* dunes = "[model]\nname = \"dunes\"\n[bed]\nkind = \"noise\"\n";
constexpr const char* pile = "[model]\nname = \"sandpile\"\ngrains_per_step = 3000\n";
constexpr const char* gully = "[model]\nname = \"gully\"\n";

PreparedRun prepared(const std::string& model, std::int64_t side, int steps, bool every_step,
                     int threads) {
    return prepare_run(
        parse_scene(fmt::format("run.steps = {}\ngrid.nx = {}\ngrid.ny = {}\n"
                                "output.measure_every = {}\noutput.frames = false\n{}",
                                steps, side, side, every_step ? 1 : steps, model),
                    "scene.toml", ""),
        threads);
}

void row(benchmark::State& state, const std::string& model, int steps) {
    const PreparedRun run = prepared(model, state.range(0), steps, true, 1);
    for (int step = 0; step < steps; ++step) run.model->step();
    Snapshot snapshot = run.model->snapshot();
    MeasureSuite suite(measured_landform(snapshot), snapshot, recorded_measures(run.scene));
    benchmark::DoNotOptimize(suite.row(snapshot));  // celerities are since the row before
    for ([[maybe_unused]] auto _ : state) {
        ++snapshot.step;
        benchmark::DoNotOptimize(suite.row(snapshot));
    }
    state.counters["seconds_a_cell"] = benchmark::Counter(
        static_cast<double>(snapshot.bed.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The least that turns of a run took.
struct Cost {
    double processor = std::numeric_limits<double>::infinity();
    double clock = std::numeric_limits<double>::infinity();

    void take_turn(const std::string& model, std::int64_t side, int steps, bool every_step) {
        PreparedRun run = prepared(model, side, steps, every_step, 0);
        const ScratchFolder folder;
        const auto file = [&](const char* name) { return folder.path() / name; };
        const double before = cpu_seconds_of_process();
        const Stopwatch watch;
        Recorder recorder(
            run.scene, run.model->snapshot(),
            {RecordPaths{file("measurements.csv"), file("avalanches.csv"), file("fields.nc")},
             {},
             false,
             0});
        Stepper(*run.model, {&recorder}).advance(at_step(steps));
        recorder.commit();
        processor = std::min(processor, cpu_seconds_of_process() - before);
        clock = std::min(clock, watch.seconds());
    }
};

void run(benchmark::State& state, const std::string& model, int steps) {
    Cost with;
    Cost without;
    for ([[maybe_unused]] auto _ : state) {  // by turns, so that both meet the same disturbances
        without.take_turn(model, state.range(0), steps, false);
        with.take_turn(model, state.range(0), steps, true);
    }
    state.counters["ratio_of_processor"] = with.processor / without.processor;
    state.counters["ratio_of_clock"] = with.clock / without.clock;
    state.counters["seconds_without"] = without.processor;
}

/// The fastest of its steps by processor time, on one thread.
void step(benchmark::State& state, const std::string& model, int before) {
    const PreparedRun run = prepared(model, state.range(0), 1, false, 1);
    for (int step = 0; step < before; ++step) run.model->step();
    double fastest = std::numeric_limits<double>::infinity();
    for ([[maybe_unused]] auto _ : state) {
        const double start = cpu_seconds_of_process();
        run.model->step();
        fastest = std::min(fastest, cpu_seconds_of_process() - start);
    }
    state.counters["seconds_a_cell"] =
        fastest / static_cast<double>(state.range(0) * state.range(0));
}

/// One thread over two, of both the fastest steps, which they take by turns.
void threads(benchmark::State& state, const std::string& model, int before) {
    const PreparedRun one = prepared(model, state.range(0), 1, false, 1);
    const PreparedRun two = prepared(model, state.range(0), 1, false, 2);
    for (int step = 0; step < before; ++step) {
        one.model->step();
        two.model->step();
    }
    struct Least {
        double processor = std::numeric_limits<double>::infinity();
        double clock = std::numeric_limits<double>::infinity();

        void step(Model& stepped) {
            const double start = cpu_seconds_of_process();
            const Stopwatch watch;
            stepped.step();
            processor = std::min(processor, cpu_seconds_of_process() - start);
            clock = std::min(clock, watch.seconds());
        }
    } of_one, of_two;
    for ([[maybe_unused]] auto _ : state) {
        of_one.step(*one.model);
        of_two.step(*two.model);
    }
    state.counters["ratio_of_processor"] = of_one.processor / of_two.processor;
    state.counters["ratio_of_clock"] = of_one.clock / of_two.clock;
}

void sides(benchmark::internal::Benchmark* one) {
    one->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
}
void turns(benchmark::internal::Benchmark* one) {
    one->Unit(benchmark::kMillisecond)->Iterations(3)->UseRealTime();
}

void steps(benchmark::internal::Benchmark* one) {
    for (std::int64_t side = 256; side <= 4096; side *= 2) one->Arg(side);
    one->Unit(benchmark::kMillisecond)->Iterations(20);
}

BENCHMARK_CAPTURE(row, ripples, ripples, 100)->Apply(sides);
BENCHMARK_CAPTURE(row, dunes, dunes, 100)->Apply(sides);
BENCHMARK_CAPTURE(row, pile, pile, 100)->Apply(sides);
BENCHMARK_CAPTURE(row, gully, gully, 20)->Apply(sides);
BENCHMARK_CAPTURE(run, ripples, ripples, 100)->Arg(512)->Apply(turns);
BENCHMARK_CAPTURE(run, dunes, dunes, 20)->Arg(1024)->Apply(turns);
BENCHMARK_CAPTURE(run, pile, pile, 100)->Arg(512)->Apply(turns);
BENCHMARK_CAPTURE(run, gully, gully, 40)->Arg(512)->Apply(turns);
BENCHMARK_CAPTURE(step, dunes, dunes, 5)->Apply(steps);
BENCHMARK_CAPTURE(threads, dunes, dunes, 5)
    ->Arg(1024)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(40);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
