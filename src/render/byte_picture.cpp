#include "render/byte_picture.h"

#include <algorithm>
#include <cstddef>

#include "base/worker_pool.h"
#include "gl/functions.h"

namespace fumon {

namespace {

constexpr int samples_per_band = 1 << 18;  // read at once: 1 MiB
constexpr int background_pixels_per_band = 1 << 18;

}  // namespace

void BytePicture::read_background(const Tile& tile, RowOrder order) {
    const auto width = static_cast<std::size_t>(tile.width);
    const int band = std::max(1, background_pixels_per_band / tile.width);
    std::vector<std::uint8_t> rgba(4 * width *
                                   static_cast<std::size_t>(std::min(band, tile.height)));
    behind_.assign(static_cast<std::size_t>(tile.height), ColourPlanes(tile.width));
    for (int first = 0; first < tile.height; first += band) {
        const int rows = std::min(band, tile.height - first);
        gl::functions().ReadPixels(0, first, tile.width, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                                   rgba.data());
        const std::uint8_t* pixel = rgba.data();
        for (int y = first; y < first + rows; ++y) {
            ColourPlanes& row = behind_[static_cast<std::size_t>(
                order == RowOrder::downward ? y : tile.height - 1 - y)];
            for (std::size_t x = 0; x < width; ++x, pixel += 4) {
                row.red[x] = pixel[0];
                row.green[x] = pixel[1];
                row.blue[x] = pixel[2];
            }
        }
    }
}

/// Reads the samples a few rows of pixels at a time, so that they stay in the cache.
void BytePicture::resolve(const Tile& tile, int factor, const glm::ivec2& from, WorkerPool& pool,
                          Image& image) {
    const int columns = tile.width * factor;
    const auto length = static_cast<std::size_t>(columns);
    const int band = std::max(1, samples_per_band / (columns * factor));  // rows of pixels
    samples_read_.resize(length * static_cast<std::size_t>(band * factor) +
                         RowResolver::samples_read_beyond);
    for (int upper = 0; upper < tile.height; upper += band) {
        const int rows = std::min(band, tile.height - upper);
        const int lowest = from.y + (tile.height - upper - rows) * factor;
        gl::functions().ReadPixels(from.x, lowest, columns, rows * factor, GL_RGBA,
                                   GL_UNSIGNED_INT_8_8_8_8_REV, samples_read_.data());
        pool.for_ranges(rows, [&](int begin, int end) {
            RowResolver row(tile.width, factor);
            for (int y = begin; y < end; ++y) {
                const int first_above = (rows - 1 - y) * factor;
                const auto above = static_cast<std::size_t>(first_above);
                for (int j = 0; j < factor; ++j)
                    row.add(samples_read_.data() + length * (above + static_cast<std::size_t>(j)));
                finish(tile, upper + y, row, image);
            }
        });
    }
}

void BytePicture::resolve(const Tile& tile, int factor, const PackedSamples& samples,
                          WorkerPool& pool, Image& image) const {
    const std::size_t length =
        static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(factor);
    pool.for_ranges(tile.height, [&](int begin, int end) {
        RowResolver row(tile.width, factor);
        std::vector<std::uint32_t> read(length * static_cast<std::size_t>(factor) +
                                        RowResolver::samples_read_beyond);
        for (int y = begin; y < end; ++y) {
            samples.write_row(tile.height - 1 - y, read.data());
            for (int j = 0; j < factor; ++j)
                row.add(read.data() + length * static_cast<std::size_t>(j));
            finish(tile, y, row, image);
        }
    });
}

void BytePicture::finish(const Tile& tile, int y, RowResolver& row, Image& image) const {
    const auto first =
        static_cast<std::size_t>(tile.y + y) * static_cast<std::size_t>(image.width) +
        static_cast<std::size_t>(tile.x);
    std::uint8_t* rgb = image.rgb.data() + 3 * first;
    if (image.transparent()) {
        row.finish_transparent(rgb, image.alpha.data() + first);
    } else {
        row.finish(behind_[static_cast<std::size_t>(y)], rgb);
    }
}

}  // namespace fumon
