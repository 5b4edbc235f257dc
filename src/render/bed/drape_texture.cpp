#include "render/bed/drape_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary_power.h"

namespace fumon {

namespace {

constexpr int drape_unit = 16;  // those before are the ground's, the water's and the sky's
constexpr std::uint32_t full_light = 65535;

/// Over a bed that repeats it does too.
gl::TextureLayout drape_layout(const LookSettings& look, const glm::dvec2& bed_share) {
    gl::TextureLayout layout;
    layout.minification = GL_LINEAR_MIPMAP_LINEAR;
    const bool repeats = look.ground == Ground::endless && bed_share == glm::dvec2(1.0);
    layout.wrap = repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    return layout;
}

/// Light of sRGB levels (IEC 61966-2-1), of `full_light`.
std::array<std::uint32_t, 256> light_of_levels() {
    std::array<std::uint32_t, 256> light{};
    for (std::size_t level = 0; level < light.size(); ++level) {
        const double display = static_cast<double>(level) / 255.0;
        const double linear =
            display <= 0.04045 ? display / 12.92 : elementary::pow((display + 0.055) / 1.055, 2.4);
        light[level] = static_cast<std::uint32_t>(full_light * linear + 0.5);
    }
    return light;
}

/// Light times opacity, and opacity, of `full_light` each.
struct LightLevel {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> values;  ///< 4 to a texel
};

/// The mean over the texel's own area of the next coarser level: along one axis a texel covers
/// `fine` / `coarse` texels of the finer level.
struct Cover {
    int first = 0;
    std::array<std::uint64_t, 3> weights{};
    int count = 0;
};

Cover cover_of(int texel, int fine, int coarse) {
    Cover cover;
    if (fine == coarse) return {texel, {1, 0, 0}, 1};
    cover.first = 2 * texel;
    if (fine == 2 * coarse) return {2 * texel, {1, 1, 0}, 2};
    const auto w = static_cast<std::uint64_t>(coarse);
    const auto t = static_cast<std::uint64_t>(texel);
    return {2 * texel, {w - t, w, t + 1}, 3};
}

LightLevel coarser(const LightLevel& fine) {
    LightLevel level{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
    level.values.resize(4 * static_cast<std::size_t>(level.width) *
                        static_cast<std::size_t>(level.height));
    std::size_t next = 0;
    for (int y = 0; y < level.height; ++y) {
        const Cover rows = cover_of(y, fine.height, level.height);
        for (int x = 0; x < level.width; ++x) {
            const Cover columns = cover_of(x, fine.width, level.width);
            std::array<std::uint64_t, 4> sums{};
            std::uint64_t all = 0;
            for (int j = 0; j < rows.count; ++j) {
                for (int i = 0; i < columns.count; ++i) {
                    const std::uint64_t weight = rows.weights[static_cast<std::size_t>(j)] *
                                                 columns.weights[static_cast<std::size_t>(i)];
                    const std::uint16_t* const texel =
                        fine.values.data() +
                        4 * (static_cast<std::ptrdiff_t>(rows.first + j) * fine.width +
                             columns.first + i);
                    for (std::size_t channel = 0; channel < 4; ++channel)
                        sums[channel] += weight * texel[channel];
                    all += weight;
                }
            }
            for (const std::uint64_t sum : sums)
                level.values[next++] = static_cast<std::uint16_t>((sum + all / 2) / all);
        }
    }
    return level;
}

/// For every light the nearest sRGB level.
std::vector<std::uint8_t> levels_of_light(const std::array<std::uint32_t, 256>& light) {
    std::vector<std::uint8_t> levels(full_light + 1);
    std::size_t level = 0;
    for (std::uint32_t value = 0; value <= full_light; ++value) {
        while (level < 255 && 2 * value >= light[level] + light[level + 1]) ++level;
        levels[value] = static_cast<std::uint8_t>(level);
    }
    return levels;
}

DrapeLevel stored(const LightLevel& level, const std::vector<std::uint8_t>& levels_of) {
    DrapeLevel result{level.width, level.height, {}};
    result.texels.reserve(level.values.size());
    for (std::size_t at = 0; at < level.values.size(); at += 4) {
        const std::uint32_t opacity = level.values[at + 3];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::uint32_t own =
                opacity == 0
                    ? 0
                    : std::min(full_light, (static_cast<std::uint32_t>(level.values[at + channel]) *
                                                full_light +
                                            opacity / 2) /
                                               opacity);
            result.texels.push_back(static_cast<std::uint8_t>(
                (levels_of[own] * opacity + full_light / 2) / full_light));
        }
        result.texels.push_back(
            static_cast<std::uint8_t>((255 * opacity + full_light / 2) / full_light));
    }
    return result;
}

}  // namespace

std::vector<DrapeLevel> drape_levels(const Drape& drape) {
    const std::array<std::uint32_t, 256> light = light_of_levels();
    const std::vector<std::uint8_t> levels_of = levels_of_light(light);
    LightLevel level{drape.width, drape.height, {}};
    level.values.resize(drape.texels.size());
    for (std::size_t at = 0; at < drape.texels.size(); at += 4) {
        const std::uint32_t opacity = drape.texels[at + 3];
        for (std::size_t channel = 0; channel < 3; ++channel)
            level.values[at + channel] = static_cast<std::uint16_t>(
                (light[drape.texels[at + channel]] * opacity + 127) / 255);
        level.values[at + 3] = static_cast<std::uint16_t>(257 * opacity);
    }
    std::vector<DrapeLevel> levels{stored(level, levels_of)};
    while (level.width > 1 || level.height > 1) {
        level = coarser(level);
        levels.push_back(stored(level, levels_of));
    }
    return levels;
}

DrapeTexture::DrapeTexture(const Drape& drape, const LookSettings& look,
                           const glm::dvec2& bed_share)
    : texture_(drape.width, drape.height, drape_layout(look, bed_share)),
      strength_(drape.strength_counts ? static_cast<float>(look.drape_strength) : 1.0F),
      bed_share_(bed_share) {
    const std::vector<DrapeLevel> levels = drape_levels(drape);
    for (std::size_t level = 0; level < levels.size(); ++level)
        texture_.set_mipmap(static_cast<int>(level), levels[level].texels.data());
}

void DrapeTexture::bind(const gl::Program& program, const glm::dvec2& texel,
                        const glm::vec2& origin) const {
    texture_.bind(drape_unit);
    program.set("drape_map", drape_unit);
    program.set("drape_strength", strength_);
    program.set("drape_share", bed_share_);
    program.set("drape_origin", origin);
    program.set("drape_texel", glm::vec2(texel));
}

}  // namespace fumon
