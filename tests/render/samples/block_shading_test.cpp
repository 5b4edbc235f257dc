#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "render/colour/grain.h"
#include "render/samples/block_vectors.h"
#include "vectors/target.h"

namespace fumon::block_vectors {
namespace {

constexpr int pixels = 83;
constexpr int bed_width = 64;
constexpr int bed_height = 48;
constexpr double depth_of_one = 2.0;  // where reversed_z is 1

std::uint32_t random_number(std::uint32_t& state) {
    state = state * 1664525U + 1013904223U;
    return state >> 8U;
}

/// Two rows of samples, seen straight from above: those of a pixel lie `apart` texels from each
/// other. Every seventh sees other things too, every eleventh a side alone.
struct Rows {
    std::vector<std::uint32_t> lower =
        std::vector<std::uint32_t>(2 * pixels + rasteriser_vectors::Band::beyond);
    std::vector<std::uint32_t> upper = lower;
    PixelRow row{};

    explicit Rows(double apart) {
        std::uint32_t state = 21;
        const auto sample = [&](std::uint32_t kind) {
            return kind == 0
                       ? 0U
                       : (std::bit_cast<std::uint32_t>(1.0F) & ~rasteriser_vectors::kind_bits) |
                             kind;
        };
        for (int x = 0; x < pixels; ++x) {
            for (int k = 0; k < EdgePixels::samples; ++k) {
                const std::uint32_t kind = x % 11 == 3   ? 4U
                                           : x % 7 == 2  ? random_number(state) % 4U
                                           : x % 13 == 5 ? 0U
                                                         : surface_kind;
                (k < 2 ? lower : upper)[static_cast<std::size_t>(2 * x + k % 2)] = sample(kind);
            }
        }
        const double by_column = apart / bed_width / depth_of_one;
        const auto east = [&](double middle) {
            return Rays{0.1F, 0.0F, static_cast<float>(middle), static_cast<float>(by_column)};
        };
        const double first = 300.0;
        row = {lower.data(),
               upper.data(),
               static_cast<int>(first),
               pixels,
               {east(-first * by_column), east(-first * by_column)},
               {Rays{0.3F, 0.0F, 0.0F, 0.0F},
                Rays{0.3F, 0.0F, static_cast<float>(apart / bed_height / depth_of_one), 0.0F}},
               {true, static_cast<float>(depth_of_one), 0.0F, 0.0F}};
    }

    [[nodiscard]] std::uint32_t kind(int x, int k) const {
        return (k < 2 ? lower : upper)[static_cast<std::size_t>(2 * x + k % 2)] &
               rasteriser_vectors::kind_bits;
    }
};

/// A place of a sample, 0 … 1, and what the bed is there, channel by channel.
struct Bed {
    std::vector<std::uint32_t> texels;

    Bed() {
        std::uint32_t state = 4;
        for (int i = 0; i < bed_width * bed_height; ++i)
            texels.push_back(0xFF000000U | (random_number(state) & 0xFFFFFFU));
    }
    [[nodiscard]] double at(double east, double north, unsigned channel) const {
        const double u = std::clamp(east, 0.0, 1.0) * bed_width - 0.5;
        const double v = std::clamp(north, 0.0, 1.0) * bed_height - 0.5;
        const auto texel = [&](int x, int y) {
            x = std::clamp(x, 0, bed_width - 1);
            y = std::clamp(y, 0, bed_height - 1);
            return static_cast<double>(
                texels[static_cast<std::size_t>(y * bed_width + x)] >> (8U * channel) & 255U);
        };
        const int x = static_cast<int>(std::floor(u));
        const int y = static_cast<int>(std::floor(v));
        const double s = u - x;
        const double t = v - y;
        return (1 - t) * ((1 - s) * texel(x, y) + s * texel(x + 1, y)) +
               t * ((1 - s) * texel(x, y + 1) + s * texel(x + 1, y + 1));
    }
};

struct Result {
    std::array<std::vector<std::uint8_t>, 3> planes;
    std::vector<std::uint8_t> state;
    EdgePixels edges;

    Result(const Rows& rows, const SurfaceTexture& surface) {
        for (std::vector<std::uint8_t>& plane : planes)
            plane.resize(pixels + rasteriser_vectors::Band::beyond);
        state.resize(pixels + rasteriser_vectors::Band::beyond);
        edges.allocate(pixels);
        shade_row(rows.row, surface,
                  {planes[0].data(), planes[1].data(), planes[2].data(), state.data()}, edges);
    }

    /// Red of the pixels that are coloured by one look.
    [[nodiscard]] std::vector<std::uint8_t> wholes() const {
        std::vector<std::uint8_t> colours;
        for (std::size_t x = 0; x < pixels; ++x) {
            const auto end = edges.pixel.begin() + static_cast<std::ptrdiff_t>(edges.count);
            const bool edge = std::find(edges.pixel.begin(), end, static_cast<int>(x)) != end;
            if (state[x] == surface_only && !edge) colours.push_back(planes[0][x]);
        }
        return colours;
    }
};

SurfaceTexture surface_of(const Bed& bed, const std::vector<std::uint32_t>* grain) {
    return {bed.texels.data(),
            bed_width,
            bed_height,
            grain != nullptr ? grain->data() : nullptr,
            900.0F,
            700.0F,
            0.3F};
}

TEST(BlockTexture, APixelIsOneLookOrFourOnEveryTarget) {
    const Bed bed;
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (const double apart : {0.6, 1.7}) {  // one look up to 1.25 texels
            const Rows rows(apart);
            const Result result(rows, surface_of(bed, nullptr));
            std::size_t edge = 0;
            for (int x = 0; x < pixels; ++x) {
                const auto at = static_cast<std::size_t>(x);
                std::array<double, 3> squares{};
                std::array<int, 8> kinds{};
                std::array<double, 3> middle{};
                for (int k = 0; k < EdgePixels::samples; ++k) {
                    ++kinds[rows.kind(x, k)];
                    const double east = 0.1 + apart / bed_width * (2 * x + k % 2 + 0.5);
                    const double north = 0.3 + apart / bed_height * (k / 2);
                    for (unsigned c = 0; c < 3; ++c) {
                        if (rows.kind(x, k) == surface_kind)
                            squares[c] += std::pow(bed.at(east, north, c), 2.0);
                        if (k == 0)
                            middle[c] = bed.at(east + 0.5 * apart / bed_width,
                                               north + 0.5 * apart / bed_height, c);
                    }
                }
                if (kinds[0] == 4 || kinds[4] == 4) {
                    EXPECT_EQ(result.state[at], kinds[4]) << "nothing, or the side's kind";
                    continue;
                }
                const bool whole = kinds[1] == 4 && apart < 1.25;
                EXPECT_EQ(result.state[at], kinds[1] == 4 ? surface_only : mixed) << target << x;
                for (unsigned c = 0; c < 3 && whole; ++c)
                    EXPECT_NEAR(result.planes[c][at], middle[c], 0.52) << target << " " << x;
                if (whole) continue;
                ASSERT_LT(edge, result.edges.count);
                EXPECT_EQ(result.edges.pixel[edge], x);
                for (unsigned c = 0; c < 3; ++c)
                    EXPECT_NEAR(std::sqrt(result.edges.sums[c][edge]), std::sqrt(squares[c]), 1.1);
                ++edge;
            }
            EXPECT_EQ(edge, result.edges.count);
        }
    }
    vectors::use_target(vectors::targets().front());
}

TEST(BlockTexture, GrainIsTheSameOnEveryTargetAndChangesNoMean) {
    const Bed bed;
    const std::vector<std::uint32_t> grain = packed_grain();
    for (const double apart : {0.02, 0.6, 1.2, 1.7}) {  // of which some take coarser levels
        const Rows rows(apart);
        vectors::use_target(vectors::targets().front());
        const Result plain(rows, surface_of(bed, nullptr));
        const Result expected(rows, surface_of(bed, &grain));
        if (apart < 1.25) {
            EXPECT_NE(expected.wholes(), plain.wholes());
        }
        double sum = 0.0;
        int largest = 0;
        for (std::size_t x = 0; x < pixels; ++x) {
            if (expected.state[x] != surface_only || apart > 1.25) continue;
            const int off = int{expected.planes[1][x]} - int{plain.planes[1][x]};
            sum += off;
            largest = std::max(largest, std::abs(off));
        }
        EXPECT_LE(std::abs(sum / pixels), 6.0);
        EXPECT_LE(largest, 0.15 * 255.0 + 1.0);
        for (const std::string& target : vectors::targets()) {
            vectors::use_target(target);
            const Result result(rows, surface_of(bed, &grain));
            EXPECT_EQ(result.state, expected.state) << target;
            EXPECT_EQ(result.wholes(), expected.wholes()) << target;
            ASSERT_EQ(result.edges.count, expected.edges.count);
            for (std::size_t i = 0; i < result.edges.count; ++i)
                for (int c = 0; c < 3; ++c)
                    EXPECT_EQ(result.edges.sums[c][i], expected.edges.sums[c][i]) << target;
        }
    }
    vectors::use_target(vectors::targets().front());
}

TEST(BlockTexture, PackedGrainHasEachTexelsNeighbours) {
    const std::vector<std::uint32_t> packed = packed_grain();
    std::vector<std::uint8_t> texels = grain_texels();
    std::size_t first = 0;
    for (int size = grain_size; size >= grain_size / 8; size /= 2) {
        const auto texel = [&](int x, int y) {
            return std::uint32_t{texels[static_cast<std::size_t>((y % size) * size + (x % size))]};
        };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(packed[first + static_cast<std::size_t>(y * size + x)],
                          texel(x, y) | texel(x + 1, y) << 8U | texel(x, y + 1) << 16U |
                              texel(x + 1, y + 1) << 24U);
        first += static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        texels = downsampled_texels(texels, size);
    }
    EXPECT_EQ(packed.size(), first);
}

}  // namespace
}  // namespace fumon::block_vectors
