// CPU milliseconds of looking at pictures: fingerprints of two pictures of 1920 × 1080 and their
// comparison, and what `fumon verify` adds to the drawing of a picture, with and without an
// expected picture.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <span>

#include "fastest.h"
#include "files/png_reader.h"
#include "picture/compare.h"
#include "picture/fingerprint.h"
#include "picture/png.h"
#include "picture/verdict.h"
#include "plain/picture_plain.h"
#include "support/pictures.h"

namespace fumon {
namespace {

using test::some_picture;

constexpr int width = 1920;
constexpr int height = 1080;

/// The picture with every level of every third row changed.
Image changed(Image image) {
    for (int y = 0; y < image.height; y += 3) {
        for (int i = 0; i < 3 * image.width; ++i) image.row(y)[i] ^= 1U;
    }
    return image;
}

void fingerprint_and_compare(benchmark::State& state) {
    const Image first = some_picture(width, height);
    const Image second = changed(first);
    while (state.KeepRunning()) {
        benchmark::DoNotOptimize(fingerprint_of(first));
        benchmark::DoNotOptimize(fingerprint_of(second));
        benchmark::DoNotOptimize(compare(first, second));
    }
}

void fingerprint(benchmark::State& state) {
    const Image image = some_picture(width, height);
    while (state.KeepRunning()) benchmark::DoNotOptimize(fingerprint_of(image));
}

void comparison(benchmark::State& state) {
    const Image first = some_picture(width, height);
    const Image second = changed(first);
    while (state.KeepRunning()) benchmark::DoNotOptimize(compare(first, second));
}

/// All that a case costs beside its drawing; range(0): whether the expected picture is kept.
void added_by_verify(benchmark::State& state) {
    const Image image = some_picture(width, height);
    const auto png = encode_png(image, 96.0, {});
    BaselineRecord record;
    record.environment = opengl_environment("osmesa", "llvmpipe", "Mesa 1", true);
    record.fingerprint = fingerprint_of(image);
    while (state.KeepRunning()) {
        BaselineRecord present = record;
        present.fingerprint = fingerprint_of(image);
        Image expected;
        if (state.range(0) != 0) {
            const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
            expected = Image(width, height);
            expected.rgb = PngReader(bytes, "expected").image().rgb;
            benchmark::DoNotOptimize(pixel_hash(expected));
        }
        benchmark::DoNotOptimize(
            judge({}, &record, present, image, state.range(0) != 0 ? &expected : nullptr));
    }
}

/// Two pictures of 33 megapixels and where they differ, beside plain loops; million pixels a
/// second.
void comparison_of_33_megapixels(benchmark::State& state) {
    constexpr double pixels = 7680.0 * 4320.0;
    const Image first = some_picture(7680, 4320);
    const Image second = changed(first);
    Fastest fastest;
    Comparison found;
    Image difference;
    while (state.KeepRunning()) {
        state.SetIterationTime(fastest.time([&] {
            found = compare(first, second);
            difference = difference_picture(first, second);
        }));
    }
    Fastest plain_fastest;
    plain::Compared plain;
    for (int turn = 0; turn < 3; ++turn)
        plain_fastest.time([&] { plain = plain::compare(first, second); });
    if (plain.difference != difference || plain.comparison.mean != found.mean ||
        plain.comparison.tiles.smallest != found.tiles.smallest)
        state.SkipWithError("the plain loops came to other numbers");
    state.counters["million_pixels_per_second"] = fastest.rate(pixels);
    state.counters["plain"] = plain_fastest.rate(pixels);
    state.counters["ratio_to_plain"] = fastest.rate(pixels) / plain_fastest.rate(pixels);
}

BENCHMARK(comparison_of_33_megapixels)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(fingerprint_and_compare)->Unit(benchmark::kMillisecond);
BENCHMARK(fingerprint)->Unit(benchmark::kMillisecond);
BENCHMARK(comparison)->Unit(benchmark::kMillisecond);
BENCHMARK(added_by_verify)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
