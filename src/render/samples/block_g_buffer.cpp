#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/rounding.h"
#include "base/worker_pool.h"
#include "render/samples/block_rasteriser.h"

// Of a block with water: the places that pixels show of its surface, and their colours.
namespace fumon {

namespace {

using g_buffer_vectors::MultiSurfacePixels;
using g_buffer_vectors::SplitRules;

constexpr float halves_apart =
    0.6F * 2.0F;  // see half_of_samples() in shaders/water/water_visibility.glsl

std::uint32_t square_of(std::uint32_t byte) {
    return byte * byte;
}

}  // namespace

/// The nearer and the farther half of the samples of a listed pixel that sees two places.
BlockRasteriser::Split BlockRasteriser::split_pixel(const MultiSurfacePixels& listed, std::size_t i,
                                                    const SplitRules& rules,
                                                    const glm::vec3& forward) {
    std::array<glm::vec3, MultiSurfacePixels::samples> positions{};
    std::array<float, MultiSurfacePixels::samples> ways{};
    std::array<bool, MultiSurfacePixels::samples> counts{};
    float nearest = std::numeric_limits<float>::max();
    float farthest = std::numeric_limits<float>::lowest();
    glm::vec3 mean(0.0F);
    int counted = 0;
    for (std::size_t k = 0; k < positions.size(); ++k) {
        counts[k] = (listed.kinds[i] >> 8 * k & 255U) == block_vectors::surface_kind;
        if (!counts[k]) continue;
        positions[k] = {listed.positions[0][k][i], listed.positions[1][k][i],
                        listed.positions[2][k][i]};
        ways[k] = glm::dot(forward, rules.low + rules.size * positions[k]);
        nearest = std::min(nearest, ways[k]);
        farthest = std::max(farthest, ways[k]);
        mean += positions[k];
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
        for (std::size_t k = 0; k < positions.size(); ++k) {
            if (!counts[k] || (ways[k] >= between) != (half == 1)) continue;
            sum += positions[k];
            least = glm::min(least, glm::vec2(positions[k]));
            most = glm::max(most, glm::vec2(positions[k]));
            ++taken;
        }
        const glm::vec2 range = glm::max(most - least, 0.0F) * rules.cells;
        const float apart = std::max({range.x, range.y, width / (halves_apart * cell_length)});
        split.positions[half] = glm::vec4(sum / static_cast<float>(std::max(taken, 1)), apart);
        split.shares[half] = static_cast<float>(taken) / static_cast<float>(std::max(counted, 1));
    }
    return split;
}

void BlockRasteriser::fill_band(int band, const GBufferSetup& setup, Scratch& scratch,
                                GBuffer& out) {
    const Camera& camera = setup.camera;
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    for (int i = 0; i < rows; ++i) {
        const int upward = band_rows * band + i;
        const std::size_t first = static_cast<std::size_t>(upward) * out.stride;
        g_buffer_vectors::Row row{pixel_row(i, band, camera, scratch), {}};
        for (int k = 0; k < factor; ++k)
            row.height[k] =
                height_rays(camera, setup.heights, first_sample_.y + factor * upward + k);
        g_buffer_vectors::resolve_positions(row, setup.rules, out.positions.data() + 4 * first,
                                            out.kinds.data() + first, scratch.state.data(),
                                            scratch.listed);
        Row& kept = rows_[static_cast<std::size_t>(tile_.height - 1 - upward)];
        list_unfinished(kept, scratch.state.data());
        kept.mixed.clear();
        kept.splits.clear();
        for (std::size_t k = 0; k < scratch.listed.count; ++k) {
            const auto x = static_cast<std::size_t>(scratch.listed.pixel[k]);
            if (scratch.state[x] == block_vectors::mixed)
                kept.mixed.push_back({{}, scratch.listed.kinds[k]});
            if (scratch.listed.are_apart[k] != 0)
                kept.splits.push_back(
                    split_pixel(scratch.listed, k, setup.rules, glm::vec3(camera.forward)));
        }
        const std::uint8_t* kinds = out.kinds.data() + first;
        const auto shows = [](std::uint8_t kind) { return kind != shows_nothing; };
        const std::uint8_t* begin = std::find_if(kinds, kinds + tile_.width, shows);
        const std::uint8_t* end = kinds + tile_.width;
        while (end != begin && !shows(end[-1])) --end;
        kept.covered = {static_cast<int>(begin - kinds), static_cast<int>(end - kinds)};
    }
}

void BlockRasteriser::fill_g_buffer(const BlockMesh& shape, const Tile& tile,
                                    const GBufferSetup& setup, WorkerPool& pool, GBuffer& out) {
    tile_ = tile;
    extent_ = shape.extent;
    set_up_triangles(shape, setup.camera, setup.picture, pool);
    rows_.resize(static_cast<std::size_t>(tile.height));
    out.allocate(tile.width, tile.height + spare_rows(tile.height));
    for_bands(pool, [&](int band, Scratch& scratch) {
        rasterise_band(band, scratch);
        fill_band(band, setup, scratch, out);
    });
    find_sides();
    bound_covered(out);
}

/// Where something is shown, and above it, where they find room, the pixels of two places.
void BlockRasteriser::bound_covered(GBuffer& out) {
    int left = tile_.width;
    int right = 0;
    int lowest = tile_.height;
    int highest = 0;
    for (int upward = 0; upward < tile_.height; ++upward) {
        const Row& row = rows_[static_cast<std::size_t>(tile_.height - 1 - upward)];
        if (row.covered.x == row.covered.y) continue;
        left = std::min(left, row.covered.x);
        right = std::max(right, row.covered.y);
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
                    out.positions[4 * texel + static_cast<std::size_t>(k)] =
                        split.positions[half][k];
                out.kinds[texel] = shows_any;
            }
        }
    }
    covered_rows_ = out.size.y;
    if (next == 0) return;
    const int rows = (next + width - 1) / width;
    for (int i = next; i < rows * width; ++i)
        out.kinds[static_cast<std::size_t>(highest + i / width) * out.stride +
                  static_cast<std::size_t>(left + i % width)] = shows_nothing;
    out.size.y += rows;
}

void BlockRasteriser::resolve_shading(GBuffer& shaded, WorkerPool& pool, Image& image) {
    const auto width = static_cast<std::size_t>(shaded.size.x);
    const auto write_row = [&](int y) {
        Row& row = rows_[static_cast<std::size_t>(y)];
        const std::size_t first =
            static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(tile_.x);
        if (image.transparent())
            std::fill_n(image.alpha.data() + first, tile_.width, std::uint8_t{255});
        const int upward = tile_.height - 1 - y;
        if (row.covered.x == row.covered.y) return;
        std::uint32_t* colours =
            shaded.colours.data() + static_cast<std::size_t>(upward - shaded.low.y) * width;
        for (const Split& split : row.splits) {
            if (split.first < 0) continue;
            const std::size_t above = static_cast<std::size_t>(covered_rows_) * width +
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
            image.rgb.data() + 3 * first + 3 * static_cast<std::size_t>(row.covered.x);
        for (int x = row.covered.x; x < row.covered.y; ++x, rgb += 3) {
            const std::uint32_t colour = colours[x - shaded.low.x];
            for (unsigned c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>(colour >> 8 * c);
        }
        auto mixed = row.mixed.begin();
        for (const Span& span : row.spans) {
            if (span.state != block_vectors::mixed) continue;
            for (int x = span.begin; x < span.end; ++x, ++mixed) {
                std::uint32_t surface_samples = 0;
                for (unsigned k = 0; k < MultiSurfacePixels::samples; ++k)
                    surface_samples +=
                        (mixed->kinds >> 8 * k & 255U) == block_vectors::surface_kind ? 1U : 0U;
                if (surface_samples == 0) continue;
                const std::uint32_t colour = colours[x - shaded.low.x];
                for (unsigned c = 0; c < 3; ++c)
                    mixed->sums[c] = surface_samples * square_of(colour >> 8 * c & 255U);
            }
        }
    };
    pool.for_ranges(tile_.height, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) write_row(y);
    });
}

}  // namespace fumon
