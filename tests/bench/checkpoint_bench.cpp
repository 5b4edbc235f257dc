// Seconds that a checkpoint takes: the model's state hashed and put on disk (fsync). Of a run with
// a checkpoint every ten minutes the share is those over 600 s.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/worker_pool.h"
#include "files/checkpoint.h"
#include "models/registry.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon {
namespace {

void measure(benchmark::State& state, const std::string& keys) {
    const auto side = std::to_string(state.range(0));
    const Scene scene = parse_scene(
        "run.steps = 100\ngrid.nx = " + side + "\ngrid.ny = " + side + "\n[model]\n" + keys,
        "scene.toml", "");
    InitialBed initial = make_initial_bed(scene);
    WorkerPool pool;
    const auto model = find_model(scene.model.name)
                           ->make(scene.model.parameters,
                                  {std::move(initial.bed), {}, initial.scale, 1, pool, false});
    const std::filesystem::path file = std::filesystem::current_path() / "checkpoint_bench.fumon";
    for ([[maybe_unused]] auto _ : state) {
        CheckpointWriter writer(file);
        model->serialise(writer);
        writer.commit();
    }
    const auto bytes = static_cast<double>(std::filesystem::file_size(file));
    state.counters["megabytes"] = 1e-6 * bytes;
    state.counters["megabytes_per_second"] = benchmark::Counter(
        1e-6 * bytes * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    std::filesystem::remove(file);
}

void sand(benchmark::State& state) {
    measure(state, "name = \"sand\"\n");
}
void sandpile(benchmark::State& state) {
    measure(state, "name = \"sandpile\"\n");
}
void gully_cip(benchmark::State& state) {
    measure(state, "name = \"gully\"\n");
}

BENCHMARK(sand)->Arg(512)->Arg(2048)->Arg(4096)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(sandpile)->Arg(512)->Arg(2048)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(gully_cip)->Arg(512)->Arg(2048)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
