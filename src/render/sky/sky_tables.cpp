#include "render/sky/sky_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/elementary.h"
#include "render/sky/ray_steps.h"
#include "render/sky/scattered_light.h"

namespace fumon {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double quarter_turn = 0.5 * pi;
constexpr int transmittance_columns = 256;  // cosine of the zenith angle
constexpr int transmittance_rows = 64;      // height
constexpr int transmittance_steps = 80;
constexpr int scattering_side = 32;
constexpr int scattering_steps = 20;
constexpr int directions_per_side = 8;
constexpr int sky_columns = 96;
constexpr int sky_rows = 108;
constexpr int radiance_steps = 32;

/// Radii from the ground to the top, closer where the air is dense (Bruneton & Neyret 2008).
struct HeightScale {
    explicit HeightScale(const Atmosphere& of)
        : air(of), horizon(std::sqrt(of.top * of.top - of.ground * of.ground)) {}

    [[nodiscard]] double to_horizon(double radius) const {
        return std::sqrt(std::max(radius * radius - air.ground * air.ground, 0.0));
    }

    const Atmosphere& air;
    double horizon;  ///< how far one sees along the ground
};

}  // namespace

glm::dvec3 LightTable::value(double x, double y) const {
    const double column = std::clamp(x, 0.0, 1.0) * (columns_ - 1);
    const double row = std::clamp(y, 0.0, 1.0) * (rows_ - 1);
    const int left = std::min(static_cast<int>(column), columns_ - 2);
    const int below = std::min(static_cast<int>(row), rows_ - 2);
    const double right_share = column - left;
    return glm::mix(glm::mix(at(left, below), at(left + 1, below), right_share),
                    glm::mix(at(left, below + 1), at(left + 1, below + 1), right_share),
                    row - below);
}

AirTables::AirTables(const Atmosphere& air)
    : air_(air),
      transmittance_(transmittance_columns, transmittance_rows),
      multiple_scattering_(scattering_side, scattering_side) {
    tabulate_transmittance();
    tabulate_multiple_scattering();
}

void AirTables::tabulate_transmittance() {
    const HeightScale scale(air_);
    for (int row = 0; row < transmittance_rows; ++row) {
        const double to_horizon = scale.horizon * row / (transmittance_rows - 1);
        const double radius = std::sqrt(to_horizon * to_horizon + air_.ground * air_.ground);
        const double shortest = air_.top - radius;
        const double longest = to_horizon + scale.horizon;
        for (int column = 0; column < transmittance_columns; ++column) {
            const double distance =
                shortest + (longest - shortest) * column / (transmittance_columns - 1);
            const double up = distance <= 0.0
                                  ? 1.0
                                  : std::clamp((scale.horizon * scale.horizon -
                                                to_horizon * to_horizon - distance * distance) /
                                                   (2.0 * radius * distance),
                                               -1.0, 1.0);
            const double step = distance / transmittance_steps;
            glm::dvec3 depth(0.0);
            for (int i = 0; i < transmittance_steps; ++i) {
                const RayPoint point = along_ray(radius, up, (i + 0.5) * step);
                const AirOptics optics = air_.optics(point.radius - air_.ground);
                depth += optics.extinction() * step;
            }
            transmittance_.at(column, row) = exp_of(-depth);
        }
    }
}

glm::dvec3 AirTables::transmittance(double radius, double up) const {
    const HeightScale scale(air_);
    const RayEnd end = end_of_ray(air_, radius, up);
    if (end.on_ground) return glm::dvec3(0.0);
    const double to_horizon = scale.to_horizon(radius);
    const double shortest = air_.top - radius;
    const double longest = to_horizon + scale.horizon;
    return transmittance_.value((end.distance - shortest) / std::max(longest - shortest, 1e-9),
                                to_horizon / scale.horizon);
}

void AirTables::tabulate_multiple_scattering() {
    constexpr double isotropic = 1.0 / (4.0 * pi);
    for (int row = 0; row < scattering_side; ++row) {
        const double height = (air_.top - air_.ground) * row / (scattering_side - 1);
        const double radius = air_.ground + std::clamp(height, 1e-3, air_.top - air_.ground - 1e-3);
        for (int column = 0; column < scattering_side; ++column) {
            const double sun_up = -1.0 + 2.0 * column / (scattering_side - 1);
            const double sun_across = std::sqrt(std::max(1.0 - sun_up * sun_up, 0.0));
            glm::dvec3 second(0.0);      // radiance scattered twice
            glm::dvec3 share_back(0.0);  // of light that leaves the point, what comes back to it
            for (int i = 0; i < directions_per_side; ++i) {
                const double up = 1.0 - 2.0 * (i + 0.5) / directions_per_side;
                const double across = std::sqrt(1.0 - up * up);
                const RayEnd end = end_of_ray(air_, radius, up);
                const double step = end.distance / scattering_steps;
                for (int j = 0; j < directions_per_side; ++j) {
                    const double azimuth = 2.0 * pi * (j + 0.5) / directions_per_side;
                    const double east = across * elementary::cos(azimuth);
                    glm::dvec3 passed(1.0);
                    for (int k = 0; k < scattering_steps; ++k) {
                        const double distance = (k + 0.5) * step;
                        const RayPoint point = along_ray(radius, up, distance);
                        const AirOptics optics = air_.optics(point.radius - air_.ground);
                        const glm::dvec3 extinction = optics.extinction();
                        const glm::dvec3 through = exp_of(-extinction * step);
                        const glm::dvec3 transmitted = passed *
                                                       effective_length(extinction, through, step) *
                                                       optics.scattering();
                        // The sun's direction is the same all along the ray.
                        const double sun_there = std::clamp(
                            (radius * sun_up + distance * (up * sun_up + east * sun_across)) /
                                point.radius,
                            -1.0, 1.0);
                        second += transmitted * transmittance(point.radius, sun_there) * isotropic;
                        share_back += transmitted;
                        passed *= through;
                    }
                    if (end.on_ground) {
                        const double sun_there = std::clamp(
                            (radius * sun_up + end.distance * (up * sun_up + east * sun_across)) /
                                air_.ground,
                            -1.0, 1.0);
                        second += passed * air_.ground_albedo *
                                  transmittance(air_.ground, sun_there) *
                                  (std::max(sun_there, 0.0) / pi);
                    }
                }
            }
            constexpr double directions = directions_per_side * directions_per_side;
            multiple_scattering_.at(column, row) =
                second / directions / (glm::dvec3(1.0) - share_back / directions);
        }
    }
}

glm::dvec3 AirTables::multiple_scattering(double radius, double sun_up) const {
    return multiple_scattering_.value(0.5 + 0.5 * sun_up,
                                      (radius - air_.ground) / (air_.top - air_.ground));
}

glm::dvec3 AirTables::radiance(double radius, double up, double sun_up, double towards_sun) const {
    const RayEnd end = end_of_ray(air_, radius, up);
    const double rayleigh = rayleigh_phase(towards_sun);
    glm::dvec3 mie;
    for (int band = 0; band < 3; ++band) mie[band] = aerosol_phase(air_, band, towards_sun);
    glm::dvec3 light(0.0);
    march(air_, radius, up, end.distance, radiance_steps, [&](const ScatteringStep& step) {
        const double there = step.point.radius;
        const double sun_there =
            std::clamp((radius * sun_up + step.middle * towards_sun) / there, -1.0, 1.0);
        const glm::dvec3 once = transmittance(there, sun_there) *
                                (step.optics.rayleigh * rayleigh + step.optics.mie * mie);
        const glm::dvec3 more = multiple_scattering(there, sun_there) * step.optics.scattering();
        light += step.transmitted * (once + more);
    });
    return light;
}

SkyView::SkyView(const AirTables& air, double sun_elevation, double eye_height, double aureole)
    : table_(sky_columns, sky_rows) {
    const double radius = air.air().ground + eye_height;
    const double sun_up = elementary::sin(sun_elevation);
    const double sun_across = elementary::cos(sun_elevation);
    sun_ = air.transmittance(radius, sun_up);
    std::vector<double> from(sky_columns);
    for (int column = 0; column < sky_columns; ++column) {
        const double root = static_cast<double>(column) / (sky_columns - 1);
        from[static_cast<std::size_t>(column)] = pi * root * root;
    }
    std::optional<ScatteredLight> followed;
    if (air.air().follows_directions) followed.emplace(air, sun_elevation);
    for (int row = 0; row < sky_rows; ++row) {
        const double root = static_cast<double>(row) / (sky_rows - 1);
        const double elevation = quarter_turn * root * root;
        const double up = elementary::sin(elevation);
        const double across = elementary::cos(elevation);
        std::vector<glm::dvec3> radiances;
        if (followed) radiances = followed->radiances(radius, up, from);
        for (int column = 0; column < sky_columns; ++column) {
            const auto number = static_cast<std::size_t>(column);
            const double towards_sun =
                up * sun_up + across * sun_across * elementary::cos(from[number]);
            table_.at(column, row) =
                followed ? radiances[number]
                         : air.radiance(radius, up, sun_up, std::clamp(towards_sun, -1.0, 1.0));
        }
    }
    constexpr int elevations = 48;
    constexpr int azimuths = 48;
    parts_.reserve(elevations * azimuths);
    const double within = elementary::cos(aureole);
    for (int i = 0; i < elevations; ++i) {
        const double elevation = quarter_turn * (i + 0.5) / elevations;
        const double level = elementary::cos(elevation);
        const double solid_angle = level * (quarter_turn / elevations) * (pi / azimuths);
        for (int j = 0; j < azimuths; ++j) {
            const double azimuth = pi * (j + 0.5) / azimuths;
            const SkyPatch part{level * elementary::cos(azimuth), level * elementary::sin(azimuth),
                                elementary::sin(elevation),
                                solid_angle * radiance(elevation, azimuth)};
            const double facing_sun = part.toward_sun * sun_across + part.up * sun_up;
            if (aureole > 0.0 && facing_sun > within) {
                aureole_ += 2.0 * facing_sun * part.light;  // of both halves
            } else {
                parts_.push_back(part);
            }
        }
    }
    level_irradiance_ = irradiance(0.0, 1.0);
}

glm::dvec3 SkyView::irradiance(double toward_sun, double up) const {
    const double across = std::sqrt(std::max(1.0 - toward_sun * toward_sun - up * up, 0.0));
    glm::dvec3 light(0.0);
    for (const SkyPatch& part : parts_) {
        const double middle = toward_sun * part.toward_sun + up * part.up;
        const double aside = across * part.across;
        light += part.light * (std::max(middle + aside, 0.0) + std::max(middle - aside, 0.0));
    }
    return light;
}

glm::dvec3 SkyView::radiance(double elevation, double azimuth) const {
    return table_.value(std::sqrt(std::max(azimuth, 0.0) / pi),
                        std::sqrt(std::max(elevation, 0.0) / quarter_turn));
}

}  // namespace fumon
