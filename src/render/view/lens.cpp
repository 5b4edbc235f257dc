#include "render/view/lens.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/error.h"

namespace fumon {

namespace {

constexpr double apart = 1.5;  // pixels, between neighbouring points of the widest blur
constexpr int fewest_points = 16;
constexpr int most_points = 128;

/// The number of Sobol's sequence in its first or second dimension, 0 … 1. The second one's
/// directions follow from the polynomial x + 1: v_i = v_(i−1) xor v_(i−1) / 2.
double sobol(std::uint32_t index, int dimension) {
    std::uint32_t direction = 1U << 31U;
    std::uint32_t sum = 0;
    for (std::uint32_t rest = index; rest != 0; rest >>= 1U) {
        if ((rest & 1U) != 0) sum ^= direction;
        direction = dimension == 0 ? direction >> 1U : direction ^ (direction >> 1U);
    }
    return std::ldexp(static_cast<double>(sum), -32);
}

}  // namespace

void check_lens(const View& view, const Snapshot& first) {
    if (view.camera.f_number.is_word() || first.scale.in_metres) return;
    throw KeyError(
        "camera.f_number",
        "camera.f_number is of a lens in millimetres, but this bed is not in metres; give "
        "grid.cell_size, or camera.aperture in sites");
}

double lens_radius(const CameraSettings& settings, const Block& block, const Camera& camera) {
    if (!settings.has_lens() || !camera.perspective) return 0.0;
    if (settings.f_number.is_word()) return 0.5 * settings.aperture / block.side;
    return 0.5 * 1e-3 * camera.focal_length / settings.f_number.value / block.side;
}

double depth_of_ground(const Camera& camera, const glm::dvec2& position, const RayGround& ground) {
    const glm::dvec3 ray = camera.forward + position.x * camera.half.x * camera.right +
                           position.y * camera.half.y * camera.up;
    const auto above = [&](double depth) {
        const glm::dvec3 point = camera.eye + depth * ray;
        return point.z - ground.height(glm::dvec2(point));
    };
    double before = 0.0;
    if (camera.eye.z > ground.highest) {
        if (ray.z >= 0.0) return std::numeric_limits<double>::infinity();
        before = (ground.highest - camera.eye.z) / ray.z;
    }
    while (before < ground.farthest) {
        double depth = before + ground.step + ground.growth * before;
        if (above(depth) > 0.0) {
            before = depth;
            if (ray.z >= 0.0 && camera.eye.z + depth * ray.z > ground.highest) break;
            continue;
        }
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (before + depth);
            (above(middle) > 0.0 ? before : depth) = middle;
        }
        return depth;
    }
    return std::numeric_limits<double>::infinity();
}

double widest_circle_of_confusion(const Camera& camera, const RayGround& ground,
                                  double pixels_high) {
    constexpr int across = 16;  // rays, and one more
    constexpr int up = 12;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
    for (int j = 0; j <= up; ++j) {
        for (int i = 0; i <= across; ++i) {
            const double depth =
                depth_of_ground(camera, {2.0 * i / across - 1.0, 2.0 * j / up - 1.0}, ground);
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    }
    const double in_focus = 1.0 / camera.lens.focus;
    const double off =
        std::max(std::abs(1.0 / nearest - in_focus), std::abs(1.0 / farthest - in_focus));
    return 2.0 * camera.lens.radius * off * pixels_high / (2.0 * camera.half.y);
}

int enough_lens_points(double widest_pixels) {
    const double across = std::min(widest_pixels / apart, 1e3);
    const double count = std::ceil(0.25 * std::numbers::pi * across * across);
    return static_cast<int>(
        std::clamp(count, static_cast<double>(fewest_points), static_cast<double>(most_points)));
}

std::vector<LensPoint> lens_points(int count) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<LensPoint> points;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt((i + 0.5) / count);
        const double angle = golden * i;
        const auto number = static_cast<std::uint32_t>(i + 1);
        points.push_back({radius * glm::dvec2(elementary::cos(angle), elementary::sin(angle)),
                          {sobol(number, 0) - 0.5, sobol(number, 1) - 0.5}});
    }
    return points;
}

}  // namespace fumon
