#include "render/samples/accumulated_light.h"

#include <algorithm>
#include <cstddef>

#include "base/worker_pool.h"
#include "gl/functions.h"

namespace fumon {

namespace {

constexpr int accumulated_pixels_per_band = 1 << 17;  // pixels read at once: 2 MiB

void add_row(const float* from, std::size_t pixels, float* to) {
    for (std::size_t x = 0; x < pixels; ++x, from += 4, to += 4) {
        const bool covered = from[3] != 0.0F;
        to[0] += covered ? from[0] : 0.0F;
        to[1] += covered ? from[1] : 0.0F;
        to[2] += covered ? from[2] : 0.0F;
        to[3] += covered ? 1.0F : 0.0F;
    }
}

}  // namespace

AccumulatedLight::AccumulatedLight(const Tile& tile)
    : tile_(tile),
      light_(4 * static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height)) {}

void AccumulatedLight::add(const glm::ivec2& from, WorkerPool& pool) {
    const std::size_t length = 4 * static_cast<std::size_t>(tile_.width);
    const int band = std::min(std::max(1, accumulated_pixels_per_band / tile_.width), tile_.height);
    read_.resize(length * static_cast<std::size_t>(band));
    for (int upper = 0; upper < tile_.height; upper += band) {
        const int rows = std::min(band, tile_.height - upper);
        const int lowest = from.y + tile_.height - upper - rows;
        gl::functions().ReadPixels(from.x, lowest, tile_.width, rows, GL_RGBA, GL_FLOAT,
                                   read_.data());
        pool.for_ranges(rows, [&](int begin, int end) {
            for (int y = begin; y < end; ++y)
                add_row(read_.data() + length * static_cast<std::size_t>(rows - 1 - y),
                        static_cast<std::size_t>(tile_.width),
                        light_.data() + length * static_cast<std::size_t>(upper + y));
        });
    }
    ++added_;
}

void AccumulatedLight::finish(WorkerPool& pool) {
    const auto count = static_cast<float>(added_);
    const std::size_t length = 4 * static_cast<std::size_t>(tile_.width);
    pool.for_ranges(tile_.height, [&](int begin, int end) {
        for (std::size_t i = length * static_cast<std::size_t>(begin);
             i < length * static_cast<std::size_t>(end); ++i)
            light_[i] /= count;
    });
}

}  // namespace fumon
