// CPU milliseconds (user and system, all threads of the process) of a picture of a changing bed at
// 1920 × 1080, 2 × 2 samples a pixel, with shadow and sky visibility at full grid resolution,
// encoded as PNG; and of its parts. Two beds take turns, so that nothing of a picture can be kept
// for the next.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "gl/functions.h"
#include "gl/handles.h"
#include "gl/texture.h"
#include "picture/png.h"
#include "render/background/background_layer.h"
#include "render/byte_picture.h"
#include "render/frame/view_uniforms.h"
#include "render/light/floor_map.h"
#include "render/light/light.h"
#include "render/light/sky_visibility.h"
#include "render/light/sun_sweep.h"
#include "render/light/view_light.h"
#include "render/renderer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/display_bed.h"
#include "support/barchan_field.h"
#include "support/dune_field.h"
#include "support/rained_gully.h"

namespace fumon {
namespace {

using test::dune_field;

double cpu_milliseconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto of = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return of(usage.ru_utime) + of(usage.ru_stime);
}

void draw(benchmark::State& state, const View& view, const std::array<Snapshot, 2>& beds) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, beds[0], 1, pool);
    benchmark::DoNotOptimize(renderer.render(beds[0]));  // compiles the shaders
    std::vector<double> frames;
    double before = cpu_milliseconds();
    std::size_t next = 1;
    while (state.KeepRunning()) {
        benchmark::DoNotOptimize(encode_png(renderer.render(beds[next]), 300.0, {}));
        next = 1 - next;
        const double now = cpu_milliseconds();
        frames.push_back(now - std::exchange(before, now));
    }
    std::sort(frames.begin(), frames.end());
    state.counters["cpu_ms"] =
        std::accumulate(frames.begin(), frames.end(), 0.0) / static_cast<double>(frames.size());
    state.counters["least"] = frames.front();
    state.counters["median"] = frames[frames.size() / 2];
}

void draw_dunes(benchmark::State& state, const View& view) {
    const auto cells = static_cast<int>(state.range(0));
    std::array<Snapshot, 2> beds = {dune_field(cells, 0.0), dune_field(cells, 0.05)};
    for (Snapshot& bed : beds) bed.periodic = true;
    draw(state, view, beds);
}

View view_of(Ground ground) {
    View view;
    view.look.ground = ground;
    return view;
}

/// A block on a table.
void picture(benchmark::State& state) {
    draw_dunes(state, view_of(Ground::table));
}

/// Endless ground from a little above it, without ripples and grain (0) or with them (1).
View endless_view(const benchmark::State& state) {
    View view = view_of(Ground::endless);
    view.camera.framing = Framing::low;
    if (state.range(1) == 0) {
        view.look.ripples = 0.0;
        view.look.grain = 0.0;
    }
    return view;
}

/// Of dunes steeper than any: half of the picture is a slip face.
void world(benchmark::State& state) {
    draw_dunes(state, endless_view(state));
}

/// Of dunes as steep as real ones.
void world_of_barchans(benchmark::State& state) {
    const auto cells = static_cast<int>(state.range(0));
    draw(state, endless_view(state),
         {test::barchan_field(cells, 0.0), test::barchan_field(cells, 2.0)});
}

/// A block with a gully, dry (0), after rain with a stream at its bottom (1) or in rain of 60 mm/h
/// whose drops are seen (2), from over its mouth (0) and as a whole (1).
void water(benchmark::State& state) {
    View view = view_of(Ground::table);
    view.look.exaggeration = {"", 1.0};
    view.look.turbidity = 0.85;
    view.look.sky = SkyModel::atmosphere;
    view.look.tone = Tone::agx_punchy;
    view.sun.azimuth = 80;
    view.sun.elevation = 22;
    if (state.range(1) == 0) {
        view.camera.at = {72, -6, 11};
        view.camera.look_at = {66, 50, 1};
        view.camera.focal_length = {"", 30.0};
    }
    if (state.range(0) == 0) {
        draw(state, view, {test::dry_gully(0.0), test::dry_gully(0.1)});
        return;
    }
    const auto gully = [&](double phase) {
        Snapshot rained = test::rained_gully(phase);
        rained.time = 600.0;
        if (state.range(0) == 2)
            rained.rain = [](double from, double until) {
                return Grid(1, 1, (until - from) / 6e4);
            };
        return rained;
    };
    draw(state, view, {gully(0.0), gully(0.1)});
}

/// The sky alone, over a whole picture, of the sun where it is (0) or of another sun each time, for
/// which its tables are made anew (1). It is read as pictures read it, and not encoded.
void sky_of_frame(benchmark::State& state) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    View view = view_of(Ground::endless);
    Camera camera;  // its lower border is the horizon
    camera.half = glm::dvec2(0.48, 0.27);
    camera.forward = glm::normalize(glm::dvec3(0.0, 1.0, camera.half.y));
    camera.up = glm::cross(camera.right, camera.forward);
    const Snapshot bed = dune_field(64, 0.0);
    const Block block = frame_block(bed, 1.0);
    Light light = light_of_view(view);
    const gl::Texture2D texture(light.sky_columns, light.sky_rows,
                                {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE},
                                light.sky_texels.data());
    BackgroundLayer background(view, block, light, open_floor(),
                               fixed_uniforms(view, light, block, PixelFormat::display_8),
                               PixelFormat::display_8);
    const Tile tile{0, 0, static_cast<int>(view.image.width), static_cast<int>(view.image.height)};
    const gl::RenderTarget target(tile.width, tile.height, colour_layout(PixelFormat::display_8));
    const gl::VertexArray no_attributes;
    BytePicture picture;
    const auto draw_sky = [&] {
        gl::functions().BindVertexArray(no_attributes.name());
        target.bind();
        texture.bind(sky_unit);
        background.draw(light, camera, tile, RowOrder::downward);
        picture.read_background(tile, RowOrder::downward);
    };
    draw_sky();  // compiles the shader
    const double before = cpu_milliseconds();
    while (state.KeepRunning()) {
        if (state.range(0) == 1) {
            view.sun.azimuth += 0.5;
            light = light_of_view(view);
            texture.upload(light.sky_texels.data());
        }
        draw_sky();
    }
    state.counters["cpu_ms"] =
        (cpu_milliseconds() - before) / static_cast<double>(state.iterations());
}

/// The sky and its light of one place of the sun, its tables included.
void atmosphere(benchmark::State& state) {
    SunSettings sun;
    while (state.KeepRunning()) benchmark::DoNotOptimize(make_atmospheric_light(sun));
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
BENCHMARK(world)->Args({512, 0})->Args({512, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(world_of_barchans)
    ->Args({512, 0})
    ->Args({512, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(water)
    ->ArgsProduct({{0, 1, 2}, {0, 1}})
    ->ArgNames({"wet", "whole"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(sky_of_frame)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(atmosphere)->Unit(benchmark::kMillisecond);
BENCHMARK(sun)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(sky)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
