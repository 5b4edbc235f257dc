#include "render/light/exposure_meter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <numbers>

#include "base/elementary_angle.h"
#include "base/elementary_power.h"

namespace fumon {

namespace {

constexpr double bright = 1.2;  // radiance times pi; level ground in the sun sends about 0.6
constexpr double compensation = 0.13;
constexpr double highest = 0.26;  // sine of an elevation

double smoothly(double from, double to, double at) {
    const double t = std::clamp((at - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Luminance of the sky in a direction above the horizon (unit vector).
double sky_luminance(const Light& light, const glm::dvec3& view) {
    const glm::dvec3 sun(light.to_sun);
    const double across =
        std::max(glm::length(glm::dvec2(view)) * glm::length(glm::dvec2(sun)), 1e-6);
    const double cosine =
        std::clamp(glm::dot(glm::dvec2(view), glm::dvec2(sun)) / across, -1.0, 1.0);
    const double azimuth = elementary::atan2(std::sqrt(1.0 - cosine * cosine), cosine);
    const double elevation = elementary::atan2(view.z, std::sqrt(1.0 - view.z * view.z));
    const double column =
        std::sqrt(azimuth / std::numbers::pi) * static_cast<double>(light.sky_columns - 1);
    const double row =
        std::sqrt(2.0 * elevation / std::numbers::pi) * static_cast<double>(light.sky_rows - 1);
    const int left = std::min(static_cast<int>(column), light.sky_columns - 2);
    const int below = std::min(static_cast<int>(row), light.sky_rows - 2);
    const auto texel = [&](int x, int y) {
        const int number = y * light.sky_columns + x;
        return glm::dvec3(light.sky_texels[static_cast<std::size_t>(number)]);
    };
    const glm::dvec3 colour = glm::mix(
        glm::mix(texel(left, below), texel(left + 1, below), column - left),
        glm::mix(texel(left, below + 1), texel(left + 1, below + 1), column - left), row - below);
    return glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace

double exposure_under_sky(const Light& light, const Camera& camera) {
    if (!camera.perspective || !light.atmosphere || light.sky_columns < 2) return 1.0;
    const double top = glm::normalize(camera.forward + camera.half.y * camera.up).z;
    const double share = smoothly(-0.09, 0.26, top);
    const double ahead = glm::length(glm::dvec2(camera.forward));
    if (share == 0.0 || ahead < 1e-6) return 1.0;
    const glm::dvec2 forward = glm::dvec2(camera.forward) / ahead;
    const glm::dvec2 right(forward.y, -forward.x);
    constexpr int columns = 9;
    constexpr int rows = 4;
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
        const double up = highest * (row + 0.5) / rows;
        for (int column = 0; column < columns; ++column) {
            const double aside = camera.half.x * (2.0 * (column + 0.5) / columns - 1.0);
            const glm::dvec2 level =
                std::sqrt(1.0 - up * up) * glm::normalize(forward + aside * right);
            sum += sky_luminance(light, {level, up});
        }
    }
    const double over = sum / (columns * rows) / bright;
    return elementary::pow(1.0 + over * over, -compensation * share);
}

}  // namespace fumon
