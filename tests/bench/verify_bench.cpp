// CPU milliseconds of looking at pictures: fingerprints of two pictures of 1920 × 1080 and their
// comparison, and what `fumon verify` adds to the drawing of a picture, with and without an
// expected picture.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <span>

#include "files/png_reader.h"
#include "picture/compare.h"
#include "picture/fingerprint.h"
#include "picture/png.h"
#include "picture/verdict.h"
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

BENCHMARK(fingerprint_and_compare)->Unit(benchmark::kMillisecond);
BENCHMARK(fingerprint)->Unit(benchmark::kMillisecond);
BENCHMARK(comparison)->Unit(benchmark::kMillisecond);
BENCHMARK(added_by_verify)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fumon

BENCHMARK_MAIN();
