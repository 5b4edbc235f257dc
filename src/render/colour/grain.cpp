#include "render/colour/grain.h"

#include <algorithm>
#include <cstddef>

#include "base/rounding.h"

namespace fumon {

namespace {

constexpr float fine_share = 0.75F;  // of single texels; the rest are patches of 4 × 4

/// A hash of a cell of a layer, 0 … 1 (the finaliser of MurmurHash3 over a linear combination).
float hash(std::uint32_t x, std::uint32_t y, std::uint32_t layer) {
    std::uint32_t h = x * 0x9e3779b1U + y * 0x85ebca77U + layer * 0xc2b2ae3dU;
    h ^= h >> 16U;
    h *= 0x85ebca6bU;
    h ^= h >> 13U;
    h *= 0xc2b2ae35U;
    h ^= h >> 16U;
    return static_cast<float>(h & 0xffffU) / 65535.0F;
}

}  // namespace

std::vector<std::uint8_t> grain_texels() {
    constexpr auto size = static_cast<std::uint32_t>(grain_size);
    std::vector<std::uint8_t> texels;
    texels.reserve(static_cast<std::size_t>(size) * size);
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const float fine = 0.5F * (hash(x, y, 0) + hash(x, y, 1));
            const float u = static_cast<float>(x % 4) / 4.0F;
            const float v = static_cast<float>(y % 4) / 4.0F;
            const std::uint32_t x0 = x / 4;
            const std::uint32_t y0 = y / 4;
            const std::uint32_t x1 = (x0 + 1) % (size / 4);
            const std::uint32_t y1 = (y0 + 1) % (size / 4);
            const float patch = (1 - v) * ((1 - u) * hash(x0, y0, 2) + u * hash(x1, y0, 2)) +
                                v * ((1 - u) * hash(x0, y1, 2) + u * hash(x1, y1, 2));
            const float value = fine_share * fine + (1.0F - fine_share) * patch;
            texels.push_back(
                static_cast<std::uint8_t>(nearest(255.0F * std::clamp(value, 0.0F, 1.0F))));
        }
    }
    return texels;
}

std::vector<std::uint8_t> downsampled_texels(const std::vector<std::uint8_t>& texels, int size) {
    const auto whole = static_cast<std::size_t>(size);
    const std::size_t half = whole / 2;
    const auto mean = [](unsigned a, unsigned b) { return (a + b + 1U) / 2U; };
    std::vector<std::uint8_t> result(half * half);
    for (std::size_t y = 0; y < half; ++y) {
        const std::uint8_t* lower = texels.data() + 2 * y * whole;
        const std::uint8_t* upper = lower + whole;
        for (std::size_t x = 0; x < half; ++x) {
            result[y * half + x] = static_cast<std::uint8_t>(
                mean(mean(lower[2 * x], lower[2 * x + 1]), mean(upper[2 * x], upper[2 * x + 1])));
        }
    }
    return result;
}

}  // namespace fumon
