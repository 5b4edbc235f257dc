// CPU milliseconds (user and system, all threads of the process) of a picture of a changing bed at
// 1920 × 1080, 2 × 2 samples a pixel, with shadow and sky visibility at full grid resolution,
// encoded as PNG; and of its parts. Two beds take turns, so that nothing of a picture can be kept
// for the next.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "gl/context.h"
#include "models/model.h"
#include "output/png.h"
#include "render/block.h"
#include "render/display_bed.h"
#include "render/light.h"
#include "render/renderer.h"
#include "render/sky_visibility.h"
#include "render/sun_sweep.h"
#include "support/worker_pool.h"

namespace fumon {
namespace {

double cpu_milliseconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto of = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return of(usage.ru_utime) + of(usage.ru_stime);
}

/// Transverse dunes that carry ripples, moved downwind by `shift` of a wavelength.
Snapshot dune_field(int cells, double shift) {
    Snapshot snapshot;
    snapshot.bed = Grid(cells, cells);
    const double wavelength = cells / 7.0;
    const double ripple = cells / 85.0;
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const double u = static_cast<double>(x) / cells;
            const double v = static_cast<double>(y) / cells;
            const double bend =
                0.5 * std::sin(5.0 * v + 2.0 * u) + 0.2 * std::sin(13.0 * v - 3.0 * u);
            const double phase = x / wavelength + bend - shift;
            const double share = phase - std::floor(phase);
            const double dune = share < 0.72
                                    ? std::pow(std::sin(1.5708 * share / 0.72), 1.5)
                                    : 0.5 + 0.5 * std::cos(3.14159 * (share - 0.72) / 0.28);
            const double small =
                std::sin(6.28319 * (x / ripple + 0.8 * std::sin(9.0 * v + 4.0 * u)));
            snapshot.bed(x, y) =
                cells * (0.025 * dune * (1.0 + 0.4 * std::sin(7.0 * v)) + 0.0006 * small);
        }
    }
    return snapshot;
}

void picture(benchmark::State& state) {
    const auto cells = static_cast<int>(state.range(0));
    std::array<Snapshot, 2> beds = {dune_field(cells, 0.0), dune_field(cells, 0.05)};
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, View{}, beds[0], 1, pool);
    benchmark::DoNotOptimize(renderer.render(beds[0]));  // compiles the shaders
    const double before = cpu_milliseconds();
    std::size_t next = 1;
    while (state.KeepRunning()) {
        benchmark::DoNotOptimize(encode_png(renderer.render(beds[next]), 300.0, {}));
        next = 1 - next;
    }
    state.counters["cpu_ms"] =
        (cpu_milliseconds() - before) / static_cast<double>(state.iterations());
}

DisplayBed bench_bed(int cells) {
    const Snapshot snapshot = dune_field(cells, 0.0);
    return display_bed(snapshot, frame_block(snapshot, 1.0), 1);
}

void sun(benchmark::State& state) {
    const DisplayBed bed = bench_bed(static_cast<int>(state.range(0)));
    const SunDirection direction = sun_direction(SunSettings{});
    while (state.KeepRunning())
        benchmark::DoNotOptimize(sun_visibility(bed.z, bed.dx, bed.dy, direction));
}

void sky(benchmark::State& state) {
    const DisplayBed bed = bench_bed(static_cast<int>(state.range(0)));
    WorkerPool pool(1);
    while (state.KeepRunning())
        benchmark::DoNotOptimize(sky_visibility(bed.z, bed.dx, bed.dy, pool));
}

BENCHMARK(picture)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sun)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(sky)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
