#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/samples/block_samples.h"

// Of a block with water: the places that pixels show of its surface, and their colours.
namespace fumon {

namespace {

using place_vectors::Listed;
using place_vectors::Rules;

constexpr float halves_apart =
    0.6F * 2.0F;  // see half_of_samples() in shaders/water/water_visibility.glsl

std::uint32_t square_of(std::uint32_t byte) {
    return byte * byte;
}

}  // namespace

/// The nearer and the farther half of the samples of a listed pixel that sees two places.
BlockSamples::Split BlockSamples::split_pixel(const Listed& listed, std::size_t i,
                                              const Rules& rules, const glm::vec3& forward) {
    std::array<glm::vec3, Listed::samples> places{};
    std::array<float, Listed::samples> ways{};
    std::array<bool, Listed::samples> counts{};
    float nearest = std::numeric_limits<float>::max();
    float farthest = std::numeric_limits<float>::lowest();
    glm::vec3 mean(0.0F);
    int counted = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        counts[k] = (listed.kinds[i] >> 8 * k & 255U) == block_vectors::surface_kind;
        if (!counts[k]) continue;
        places[k] = {listed.places[0][k][i], listed.places[1][k][i], listed.places[2][k][i]};
        ways[k] = glm::dot(forward, rules.low + rules.size * places[k]);
        nearest = std::min(nearest, ways[k]);
        farthest = std::max(farthest, ways[k]);
        mean += places[k];
        ++counted;
    }
    mean /= static_cast<float>(std::max(counted, 1));
    const float between = 0.5F * (nearest + farthest);
    const float width =
        rules.pixel_width * (rules.perspective ? glm::length(rules.low + rules.size * mean) : 1.0F);
    const float cell_length = rules.size.x / rules.cells.x;
    Split split{listed.pixel[i], {}, {}};
    for (std::size_t half = 0; half < 2; ++half) {
        glm::vec3 sum(0.0F);
        glm::vec2 least(2.0F);
        glm::vec2 most(-1.0F);
        int taken = 0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            if (!counts[k] || (ways[k] >= between) != (half == 1)) continue;
            sum += places[k];
            least = glm::min(least, glm::vec2(places[k]));
            most = glm::max(most, glm::vec2(places[k]));
            ++taken;
        }
        const glm::vec2 range = glm::max(most - least, 0.0F) * rules.cells;
        const float apart = std::max({range.x, range.y, width / (halves_apart * cell_length)});
        split.places[half] = glm::vec4(sum / static_cast<float>(std::max(taken, 1)), apart);
        split.shares[half] = static_cast<float>(taken) / static_cast<float>(std::max(counted, 1));
    }
    return split;
}

void BlockSamples::place_band(int band, const Seeing& seeing, Room& room, PixelPlaces& out) {
    const Camera& camera = seeing.camera;
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    for (int i = 0; i < rows; ++i) {
        const int upward = band_rows * band + i;
        const std::size_t first = static_cast<std::size_t>(upward) * out.stride;
        place_vectors::Row row{pixel_row(i, band, camera, room), {}};
        for (int k = 0; k < factor; ++k)
            row.height[k] =
                height_rays(camera, seeing.heights, first_sample_.y + factor * upward + k);
        place_vectors::find_places(row, seeing.rules, out.places.data() + 4 * first,
                                   out.kinds.data() + first, room.state.data(), room.listed);
        Row& kept = rows_[static_cast<std::size_t>(tile_.height - 1 - upward)];
        list_unfinished(kept, room.state.data());
        kept.mixed.clear();
        kept.splits.clear();
        for (std::size_t k = 0; k < room.listed.count; ++k) {
            const auto x = static_cast<std::size_t>(room.listed.pixel[k]);
            if (room.state[x] == block_vectors::mixed)
                kept.mixed.push_back({{}, room.listed.kinds[k]});
            if (room.listed.are_apart[k] != 0)
                kept.splits.push_back(
                    split_pixel(room.listed, k, seeing.rules, glm::vec3(camera.forward)));
        }
        const std::uint8_t* kinds = out.kinds.data() + first;
        const auto shows = [](std::uint8_t kind) { return kind != shows_nothing; };
        const std::uint8_t* begin = std::find_if(kinds, kinds + tile_.width, shows);
        const std::uint8_t* end = kinds + tile_.width;
        while (end != begin && !shows(end[-1])) --end;
        kept.shown = {static_cast<int>(begin - kinds), static_cast<int>(end - kinds)};
    }
}

void BlockSamples::see_places(const BlockShape& shape, const Tile& tile, const Seeing& seeing,
                              WorkerPool& pool, PixelPlaces& out) {
    tile_ = tile;
    extent_ = shape.extent;
    place(shape, seeing.camera, seeing.picture, pool);
    rows_.resize(static_cast<std::size_t>(tile.height));
    out.make_room(tile.width, tile.height + spare_rows(tile.height));
    for_bands(pool, [&](int band, Room& room) {
        draw_band(band, room);
        place_band(band, seeing, room, out);
    });
    find_sides();
    frame_shown(out);
}

/// Where something is shown, and above it, where they find room, the pixels of two places.
void BlockSamples::frame_shown(PixelPlaces& out) {
    int left = tile_.width;
    int right = 0;
    int lowest = tile_.height;
    int highest = 0;
    for (int upward = 0; upward < tile_.height; ++upward) {
        const Row& row = rows_[static_cast<std::size_t>(tile_.height - 1 - upward)];
        if (row.shown.x == row.shown.y) continue;
        left = std::min(left, row.shown.x);
        right = std::max(right, row.shown.y);
        lowest = std::min(lowest, upward);
        highest = upward + 1;
    }
    out.low = {left, lowest};
    out.size = glm::max(glm::ivec2(right, highest) - out.low, 0);
    const int width = out.size.x;
    int next = 0;
    const int most = width * spare_rows(tile_.height);
    for (int upward = lowest; upward < highest; ++upward) {
        Row& row = rows_[static_cast<std::size_t>(tile_.height - 1 - upward)];
        std::uint8_t* kinds = out.kinds.data() + static_cast<std::size_t>(upward) * out.stride;
        for (Split& split : row.splits) {
            if (next + 2 > most) {
                split.first = -1;  // shaded as one, where its samples are in the mean
                continue;
            }
            split.first = next;
            kinds[split.pixel] = shows_nothing;
            for (std::size_t half = 0; half < 2; ++half, ++next) {
                const auto texel = static_cast<std::size_t>(highest + next / width) * out.stride +
                                   static_cast<std::size_t>(left + next % width);
                for (int k = 0; k < 4; ++k)
                    out.places[4 * texel + static_cast<std::size_t>(k)] = split.places[half][k];
                out.kinds[texel] = shows_any;
            }
        }
    }
    shown_rows_ = out.size.y;
    if (next == 0) return;
    const int rows = (next + width - 1) / width;
    for (int i = next; i < rows * width; ++i)
        out.kinds[static_cast<std::size_t>(highest + i / width) * out.stride +
                  static_cast<std::size_t>(left + i % width)] = shows_nothing;
    out.size.y += rows;
}

void BlockSamples::put_colours(PixelPlaces& shaded, WorkerPool& pool, Image& image) {
    const auto width = static_cast<std::size_t>(shaded.size.x);
    const auto put_row = [&](int y) {
        Row& row = rows_[static_cast<std::size_t>(y)];
        const std::size_t first =
            static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(tile_.x);
        if (image.transparent())
            std::fill_n(image.alpha.data() + first, tile_.width, std::uint8_t{255});
        const int upward = tile_.height - 1 - y;
        if (row.shown.x == row.shown.y) return;
        std::uint32_t* colours =
            shaded.colours.data() + static_cast<std::size_t>(upward - shaded.low.y) * width;
        for (const Split& split : row.splits) {
            if (split.first < 0) continue;
            const std::size_t above = static_cast<std::size_t>(shown_rows_) * width +
                                      static_cast<std::size_t>(split.first);
            std::uint32_t mixed = 0xFF000000U;
            for (unsigned c = 0; c < 3; ++c) {
                float sum = 0.0F;
                for (std::size_t half = 0; half < 2; ++half)
                    sum +=
                        split.shares[half] *
                        static_cast<float>(square_of(shaded.colours[above + half] >> 8 * c & 255U));
                mixed |= static_cast<std::uint32_t>(nearest(std::sqrt(sum))) << 8 * c;
            }
            colours[split.pixel - shaded.low.x] = mixed;
        }
        std::uint8_t* rgb =
            image.rgb.data() + 3 * first + 3 * static_cast<std::size_t>(row.shown.x);
        for (int x = row.shown.x; x < row.shown.y; ++x, rgb += 3) {
            const std::uint32_t colour = colours[x - shaded.low.x];
            for (unsigned c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>(colour >> 8 * c);
        }
        auto mixed = row.mixed.begin();
        for (const Run& run : row.runs) {
            if (run.state != block_vectors::mixed) continue;
            for (int x = run.begin; x < run.end; ++x, ++mixed) {
                std::uint32_t seen = 0;
                for (unsigned k = 0; k < Listed::samples; ++k)
                    seen += (mixed->kinds >> 8 * k & 255U) == block_vectors::surface_kind ? 1U : 0U;
                if (seen == 0) continue;
                const std::uint32_t colour = colours[x - shaded.low.x];
                for (unsigned c = 0; c < 3; ++c)
                    mixed->sums[c] = seen * square_of(colour >> 8 * c & 255U);
            }
        }
    };
    pool.for_ranges(tile_.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) put_row(y);
    });
}

}  // namespace fumon
