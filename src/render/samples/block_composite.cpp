#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/samples/block_rasteriser.h"

// What is left of a block's pixels where they see more than its surface.
namespace fumon {

namespace {

using block_vectors::EdgePixels;

std::uint32_t squared(std::uint32_t byte) {
    return byte * byte;
}

bool is_side(std::uint32_t state) {
    return state >= BlockRasteriser::first_side && state < BlockRasteriser::first_side + 4;
}

}  // namespace

std::uint8_t BlockRasteriser::root_of_mean(std::uint32_t sum, std::uint32_t count) {
    const float mean = static_cast<float>(sum) / static_cast<float>(std::max(count, 1U));
    return static_cast<std::uint8_t>(nearest(std::sqrt(mean)));
}

void BlockRasteriser::find_sides() {
    struct Box {
        int left = std::numeric_limits<int>::max();
        int right = 0;
        int upper = std::numeric_limits<int>::max();
        int lower = 0;
    };
    std::array<Box, 4> boxes;
    for (int y = 0; y < tile_.height; ++y) {
        const Row& row = rows_[static_cast<std::size_t>(y)];
        const auto add = [&](std::uint32_t kind, int begin, int end) {
            if (!is_side(kind)) return;
            Box& box = boxes[kind - first_side];
            box.left = std::min(box.left, begin);
            box.right = std::max(box.right, end);
            box.upper = std::min(box.upper, y);
            box.lower = y + 1;
        };
        auto mixed = row.mixed.begin();
        for (const Span& span : row.spans) {
            add(span.state, span.begin, span.end);
            if (span.state != block_vectors::mixed) continue;
            for (int x = span.begin; x < span.end; ++x, ++mixed)
                for (unsigned k = 0; k < EdgePixels::samples; ++k)
                    add(mixed->kinds >> 8 * k & 255U, x, x + 1);
        }
    }
    for (std::size_t side = 0; side < boxes.size(); ++side) {
        const Box& box = boxes[side];
        sides_[side].part = {};
        if (box.right == 0) continue;
        const int left = std::max(box.left - 1, 0);  // see colour_of()
        const int upper = std::max(box.upper - 1, 0);
        const int right = std::min(box.right + 1, tile_.width);
        const int lower = std::min(box.lower + 1, tile_.height);
        sides_[side].part = {left, upper, right - left, lower - upper};
    }
}

std::vector<Tile> BlockRasteriser::background_rectangles() const {
    constexpr int cell = 16;  // pixels
    const int columns = (tile_.width + cell - 1) / cell;
    std::vector<Tile> parts;
    std::vector<std::uint8_t> open(static_cast<std::size_t>(columns) + 1);
    for (int upper = 0; upper < tile_.height; upper += cell) {
        const int lower = std::min(upper + cell, tile_.height);
        std::fill(open.begin(), open.end(), std::uint8_t{0});
        const auto mark = [&](int begin, int end) {
            for (int i = begin / cell; i <= (end - 1) / cell; ++i)
                open[static_cast<std::size_t>(i)] = 1;
        };
        for (int y = upper; y < lower; ++y) {
            const Row& row = rows_[static_cast<std::size_t>(y)];
            auto mixed = row.mixed.begin();
            for (const Span& span : row.spans) {
                if (span.state == block_vectors::uncovered) mark(span.begin, span.end);
                if (span.state != block_vectors::mixed) continue;
                for (int x = span.begin; x < span.end; ++x, ++mixed) {
                    const std::uint32_t kinds = mixed->kinds;
                    const bool some_open = (kinds & 255U) == 0 || (kinds >> 8U & 255U) == 0 ||
                                           (kinds >> 16U & 255U) == 0 || kinds >> 24U == 0;
                    if (some_open) mark(x, x + 1);
                }
            }
        }
        for (int i = 0; i < columns; ++i) {
            if (open[static_cast<std::size_t>(i)] == 0) continue;
            const int begin = i;
            while (open[static_cast<std::size_t>(i)] != 0) ++i;  // the one after the last is 0
            const int right = std::min(cell * i, tile_.width);
            parts.push_back({cell * begin, upper, right - cell * begin, lower - upper});
        }
    }
    return parts;
}

/// Of the nearest pixel that was coloured, as a side that is seen from its edge may cover no
/// pixel's middle; 0 if there is none.
std::uint32_t BlockRasteriser::colour_of(int kind, int x, int y) const {
    const Side& side = sides_[static_cast<std::size_t>(kind - first_side)];
    const Tile& part = side.part;
    const int column = x - part.x;
    const int row = part.y + part.height - 1 - y;
    const auto at = [&](int u, int v) {
        return side.colours[static_cast<std::size_t>(v) * static_cast<std::size_t>(part.width) +
                            static_cast<std::size_t>(u)];
    };
    if (at(column, row) != 0) return at(column, row);
    constexpr int farthest = 16;
    for (int reach = 1; reach <= farthest; ++reach) {
        for (int v = std::max(row - reach, 0); v <= std::min(row + reach, part.height - 1); ++v)
            for (int u = std::max(column - reach, 0); u <= std::min(column + reach, part.width - 1);
                 ++u)
                if (at(u, v) != 0) return at(u, v);
    }
    return 0;
}

/// A pixel that sees several things, over what is behind it, if there is something; how many of its
/// samples have a colour.
std::uint32_t BlockRasteriser::finish_mixed(const MixedPixel& mixed, int x, int y,
                                            const std::vector<ColourPlanes>* behind,
                                            std::uint8_t* pixel) const {
    std::array<std::uint32_t, 3> sums = mixed.sums;
    std::uint32_t covered = EdgePixels::samples;
    for (unsigned k = 0; k < EdgePixels::samples; ++k) {
        const std::uint32_t kind = mixed.kinds >> 8 * k & 255U;
        if (is_side(kind)) {
            const std::uint32_t colour = colour_of(static_cast<int>(kind), x, y);
            if (colour == 0) --covered;
            for (unsigned c = 0; c < 3; ++c) sums[c] += squared(colour >> 8 * c & 255U);
        } else if (kind == 0 && behind == nullptr) {
            --covered;
        } else if (kind == 0) {
            const ColourPlanes& back = (*behind)[static_cast<std::size_t>(y)];
            const auto at = static_cast<std::size_t>(x);
            sums[0] += squared(back.red[at]);
            sums[1] += squared(back.green[at]);
            sums[2] += squared(back.blue[at]);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = root_of_mean(sums[c], covered);
    return covered;
}

void BlockRasteriser::finish(const std::vector<ColourPlanes>& behind, WorkerPool& pool,
                             Image& image) const {
    const bool open = image.transparent();
    const auto finish_row = [&](int y) {
        const Row& row = rows_[static_cast<std::size_t>(y)];
        const std::size_t first =
            static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(tile_.x);
        std::uint8_t* rgb = image.rgb.data() + 3 * first;
        const auto put_pixel = [](std::uint32_t colour, std::uint8_t* pixel) {
            for (unsigned c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(colour >> 8 * c);
        };
        auto mixed = row.mixed.begin();
        for (const Span& span : row.spans) {
            const auto begin = static_cast<std::size_t>(span.begin);
            const auto end = static_cast<std::size_t>(span.end);
            std::uint8_t* pixel = rgb + 3 * begin;
            if (span.state == block_vectors::uncovered && open) {
                std::fill(pixel, rgb + 3 * end, std::uint8_t{0});
                std::fill_n(image.alpha.data() + first + begin, end - begin, std::uint8_t{0});
            } else if (span.state == block_vectors::uncovered) {
                const ColourPlanes& back = behind[static_cast<std::size_t>(y)];
                for (std::size_t x = begin; x < end; ++x) {
                    *pixel++ = back.red[x];
                    *pixel++ = back.green[x];
                    *pixel++ = back.blue[x];
                }
            } else if (span.state != block_vectors::mixed) {
                for (int x = span.begin; x < span.end; ++x, pixel += 3)
                    put_pixel(colour_of(span.state, x, y), pixel);
            } else {
                for (int x = span.begin; x < span.end; ++x, ++mixed, pixel += 3) {
                    const std::uint32_t covered =
                        finish_mixed(*mixed, x, y, open ? nullptr : &behind, pixel);
                    if (open)
                        image.alpha[first + static_cast<std::size_t>(x)] =
                            static_cast<std::uint8_t>((255U * covered + EdgePixels::samples / 2U) /
                                                      EdgePixels::samples);
                }
            }
        }
    };
    pool.for_ranges(tile_.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) finish_row(y);
    });
}

}  // namespace fumon
