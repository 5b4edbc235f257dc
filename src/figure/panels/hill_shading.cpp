#include "figure/panels/hill_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "render/light/light.h"
#include "render/light/lighting.h"
#include "render/view/display_bed.h"

namespace fumon {

namespace {

constexpr double least_sun_sine = 0.25;  // sine of its elevation, by which level ground is dimmed
constexpr double most_direct_light_ratio = 1.6;  // share of direct light, of that on level ground
// As the renderer's figures are lit: what reaches every place, the sky's and the sun's share.
constexpr double ambient_light_share = 0.30;
constexpr double sky_light_share = 0.32;
constexpr double sun_light_share = 0.38;

}  // namespace

Field<float> hill_light(const Snapshot& snapshot, const HillShading& shading, WorkerPool& pool) {
    const Block block = frame_block(snapshot, shading.exaggeration);
    const DisplayBed bed = display_bed(snapshot, block, 1);
    const auto texels = lighting_texels(bed, sun_direction(shading.sun), pool);
    constexpr std::array<double, 4> sides{-67.5, -22.5, 22.5, 67.5};  // degrees from the sun
    constexpr std::array<double, 1> sun_only{0.0};
    const std::span<const double> turns =
        shading.from_all_sides ? std::span<const double>(sides) : std::span<const double>(sun_only);
    std::array<glm::dvec3, sides.size()> lights{};
    for (std::size_t i = 0; i < turns.size(); ++i) {
        SunSettings turned = shading.sun;
        turned.azimuth += turns[i];
        lights.at(i) = glm::dvec3(make_light(turned).to_sun);
    }
    Field<float> light(snapshot.bed.nx(), snapshot.bed.ny());
    constexpr double whole = 65535.0;
    for (std::size_t cell = 0; cell < light.size(); ++cell) {
        const auto* texel = texels.data() + 4 * cell;
        glm::dvec3 normal(texel[0] / 32767.0 - 1.0, texel[1] / 32767.0 - 1.0, 0.0);
        normal.z = std::sqrt(std::max(0.0, 1.0 - normal.x * normal.x - normal.y * normal.y));
        const double sun = shading.from_all_sides ? 1.0 : texel[2] / whole;
        double lit = 0.0;
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const double level = std::max(lights.at(i).z, least_sun_sine);
            lit += std::min(sun * std::max(glm::dot(normal, lights.at(i)), 0.0) / level,
                            most_direct_light_ratio);
        }
        lit /= static_cast<double>(turns.size());
        const double all =
            ambient_light_share + sky_light_share * texel[3] / whole + sun_light_share * lit;
        light.values()[cell] =
            static_cast<float>(std::lerp(1.0, std::min(all, 1.0), shading.strength));
    }
    return light;
}

}  // namespace fumon
