#include "render/sky/scattered_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

#include "base/elementary.h"
#include "render/sky/ray_steps.h"

namespace fumon {

namespace {

constexpr double half_turn = std::numbers::pi;
constexpr int height_count = 12;
constexpr int ups = 20;       // of equal steps in the sine of the elevation
constexpr int azimuths = 18;  // of one half of all directions; the other is its mirror image
constexpr int band_count = 3;
constexpr int differences = 2 * azimuths;  // between azimuths
constexpr int kinds = 1 + band_count;      // of phase functions
constexpr int steps_between = 20;          // from height to height
constexpr int steps_to_eye = 32;
constexpr int rounds = 6;
constexpr int numbers_per_direction = band_count * height_count;
constexpr double solid_angle = 2.0 / ups * half_turn / azimuths;

std::size_t index_of(int number) {
    return static_cast<std::size_t>(number);
}

double up_of(int number) {
    return -1.0 + 2.0 * (number + 0.5) / ups;
}

double azimuth_of(int number) {
    return half_turn * (number + 0.5) / azimuths;
}

/// Where a direction's numbers begin.
std::size_t begin_of(int up, int azimuth) {
    return index_of((up * azimuths + azimuth) * numbers_per_direction);
}

std::size_t phase_index(int to, int from, int difference) {
    return index_of(((to * ups + from) * differences + difference) * kinds);
}

double mixed(double one, double other, double share) {
    return one + share * (other - one);
}

}  // namespace

ScatteredLight::ScatteredLight(const AirTables& air, double sun_elevation)
    : air_(air),
      sun_up_(elementary::sin(sun_elevation)),
      sun_across_(elementary::cos(sun_elevation)),
      by_molecules_(begin_of(ups, 0), 0.0),
      by_aerosol_(begin_of(ups, 0), 0.0) {
    for (int i = 0; i < height_count; ++i) {
        const double share = static_cast<double>(i) / (height_count - 1);
        heights_.push_back((air.air().top - air.air().ground) * share * share * share);
    }
    tabulate_phases();
    std::vector<Path> paths;
    for (const double height : heights_) {
        const double least = 1e-3;
        const double radius =
            std::clamp(air.air().ground + height, air.air().ground + least, air.air().top - least);
        for (int up = 0; up < ups; ++up)
            paths.push_back(path_from(radius, up_of(up), steps_between));
    }
    const Field once = scattered_once(paths);
    Field light = once;
    for (int round = 0; round < rounds; ++round) {
        scatter(light);
        if (round + 1 < rounds) light = arriving(paths, once, on_ground(light));
    }
}

ScatteredLight::GridPosition ScatteredLight::grid_position(double height, double up) const {
    GridPosition position{};
    while (position.height < height_count - 2 && heights_[index_of(position.height) + 1] < height)
        ++position.height;
    const double below = heights_[index_of(position.height)];
    const double above = heights_[index_of(position.height) + 1];
    position.height_share = std::clamp((height - below) / (above - below), 0.0, 1.0);
    const double along = std::clamp(0.5 * (up + 1.0) * ups - 0.5, 0.0, ups - 1.0);
    position.up = std::min(static_cast<int>(along), ups - 2);
    position.up_share = along - position.up;
    return position;
}

double ScatteredLight::towards_sun(double up, double azimuth) const {
    const double across = std::sqrt(std::max(1.0 - up * up, 0.0));
    return std::clamp(up * sun_up_ + across * sun_across_ * elementary::cos(azimuth), -1.0, 1.0);
}

ScatteredLight::Path ScatteredLight::path_from(double radius, double up, int steps) const {
    const Atmosphere& air = air_.air();
    const RayEnd end = end_of_ray(air, radius, up);
    Path path;
    const auto add = [&](const ScatteringStep& step) {
        const RayPoint& point = step.point;
        path.steps.push_back({grid_position(point.radius - air.ground, point.up), step.middle,
                              point.radius, step.transmitted * step.optics.rayleigh,
                              step.transmitted * step.optics.mie,
                              glm::max(air_.multiple_scattering(point.radius, sun_up_), 1e-12)});
    };
    const glm::dvec3 passed = march(air, radius, up, end.distance, steps, add);
    if (end.on_ground) path.from_ground = passed * air.ground_albedo;
    return path;
}

ScatteredLight::Field ScatteredLight::scattered_once(const std::vector<Path>& paths) const {
    const double ground = air_.air().ground;
    const glm::dvec3 sunlit =
        air_.transmittance(ground, sun_up_) * (std::max(sun_up_, 0.0) / half_turn);
    Field field(begin_of(ups, 0), 0.0);
    for (int height = 0; height < height_count; ++height) {
        const double radius = ground + heights_[index_of(height)];
        for (int up = 0; up < ups; ++up) {
            const Path& path = paths[index_of(height * ups + up)];
            for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
                const double cosine = towards_sun(up_of(up), azimuth_of(azimuth));
                const double molecules = rayleigh_phase(cosine);
                glm::dvec3 aerosol;
                for (int band = 0; band < band_count; ++band)
                    aerosol[band] = aerosol_phase(air_.air(), band, cosine);
                glm::dvec3 light = path.from_ground * sunlit;
                for (const PathStep& step : path.steps) {
                    const double sun_there = std::clamp(
                        (radius * sun_up_ + step.distance * cosine) / step.radius, -1.0, 1.0);
                    light += air_.transmittance(step.radius, sun_there) *
                             (molecules * step.of_molecules + aerosol * step.of_aerosol);
                }
                for (int band = 0; band < band_count; ++band)
                    field[begin_of(up, azimuth) + index_of(band * height_count + height)] =
                        light[band];
            }
        }
    }
    return field;
}

ScatteredLight::Field ScatteredLight::arriving(const std::vector<Path>& paths, const Field& once,
                                               const glm::dvec3& ground) const {
    Field light = once;
    for (int height = 0; height < height_count; ++height) {
        for (int up = 0; up < ups; ++up) {
            const Path& path = paths[index_of(height * ups + up)];
            for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
                for (int band = 0; band < band_count; ++band) {
                    double sum = path.from_ground[band] * ground[band];
                    for (const PathStep& step : path.steps) {
                        const auto row = index_of(band * height_count + step.position.height);
                        const std::size_t low = begin_of(step.position.up, azimuth) + row;
                        const std::size_t high = begin_of(step.position.up + 1, azimuth) + row;
                        const auto there = [&](const Field& field) {
                            return mixed(
                                mixed(field[low], field[low + 1], step.position.height_share),
                                mixed(field[high], field[high + 1], step.position.height_share),
                                step.position.up_share);
                        };
                        sum += step.of_molecules[band] * there(by_molecules_) +
                               step.of_aerosol[band] * there(by_aerosol_);
                    }
                    light[begin_of(up, azimuth) + index_of(band * height_count + height)] += sum;
                }
            }
        }
    }
    return light;
}

glm::dvec3 ScatteredLight::on_ground(const Field& light) const {
    glm::dvec3 sum(0.0);
    for (int up = ups / 2; up < ups; ++up) {
        for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
            for (int band = 0; band < band_count; ++band)
                sum[band] +=
                    up_of(up) * light[begin_of(up, azimuth) + index_of(band * height_count)];
        }
    }
    return sum * (2.0 * solid_angle / half_turn);
}

void ScatteredLight::tabulate_phases() {
    phases_.resize(phase_index(ups, 0, 0));
    for (int to = 0; to < ups; ++to) {
        const double across = std::sqrt(1.0 - up_of(to) * up_of(to));
        std::array<double, kinds> sums{};
        for (int from = 0; from < ups; ++from) {
            const double across_from = std::sqrt(1.0 - up_of(from) * up_of(from));
            for (int difference = 0; difference < differences; ++difference) {
                const double cosine = std::clamp(
                    up_of(to) * up_of(from) +
                        across * across_from * elementary::cos(half_turn * difference / azimuths),
                    -1.0, 1.0);
                double* phase = &phases_[phase_index(to, from, difference)];
                phase[0] = rayleigh_phase(cosine);
                for (int band = 0; band < band_count; ++band)
                    phase[1 + band] = aerosol_phase(air_.air(), band, cosine);
                for (int kind = 0; kind < kinds; ++kind) sums[index_of(kind)] += phase[kind];
            }
        }
        // Whole light is scattered, however coarse the directions.
        for (std::size_t i = phase_index(to, 0, 0); i < phase_index(to + 1, 0, 0); ++i)
            phases_[i] /= sums[(i - phase_index(to, 0, 0)) % kinds];
    }
}

void ScatteredLight::scatter(const Field& light) {
    std::fill(by_molecules_.begin(), by_molecules_.end(), 0.0);
    std::fill(by_aerosol_.begin(), by_aerosol_.end(), 0.0);
    for (int to = 0; to < ups; ++to) {
        for (int from = 0; from < ups; ++from) {
            for (int i = 0; i < azimuths; ++i) {
                double* molecules = &by_molecules_[begin_of(to, i)];
                double* aerosol = &by_aerosol_[begin_of(to, i)];
                for (int j = 0; j < azimuths; ++j) {
                    // From the direction itself and its mirror image.
                    const double* one = &phases_[phase_index(to, from, std::abs(i - j))];
                    const double* other = &phases_[phase_index(to, from, i + j + 1)];
                    const double* comes = &light[begin_of(from, j)];
                    const double by_all = one[0] + other[0];
                    for (int k = 0; k < numbers_per_direction; ++k)
                        molecules[k] += by_all * comes[k];
                    for (int band = 0; band < band_count; ++band) {
                        const double by_band = one[1 + band] + other[1 + band];
                        for (int k = band * height_count; k < (band + 1) * height_count; ++k)
                            aerosol[k] += by_band * comes[k];
                    }
                }
            }
        }
    }
}

std::vector<glm::dvec3> ScatteredLight::radiances(double radius, double up,
                                                  const std::vector<double>& from) const {
    const Path path = path_from(radius, up, steps_to_eye);
    std::vector<glm::dvec3> all;
    for (const double azimuth : from) {
        const double cosine = towards_sun(up, azimuth);
        const double molecules = rayleigh_phase(cosine);
        glm::dvec3 aerosol;
        for (int band = 0; band < band_count; ++band)
            aerosol[band] = aerosol_phase(air_.air(), band, cosine);
        const double across = std::clamp(azimuth / half_turn * azimuths - 0.5, 0.0, azimuths - 1.0);
        const int nearest = std::min(static_cast<int>(across), azimuths - 2);
        const double share = across - nearest;
        glm::dvec3 light(0.0);
        for (const PathStep& step : path.steps) {
            const double sun_there =
                std::clamp((radius * sun_up_ + step.distance * cosine) / step.radius, -1.0, 1.0);
            const glm::dvec3 sun = air_.transmittance(step.radius, sun_there);
            const glm::dvec3 local =
                glm::min(air_.multiple_scattering(step.radius, sun_there) / step.isotropic, 4.0);
            for (int band = 0; band < band_count; ++band) {
                const auto row = index_of(band * height_count + step.position.height);
                const std::size_t low = begin_of(step.position.up, nearest) + row;
                const std::size_t high = begin_of(step.position.up + 1, nearest) + row;
                const auto there = [&](const Field& field) {
                    const auto at = [&](std::size_t i) {
                        return mixed(field[i], field[i + 1], step.position.height_share);
                    };
                    return mixed(mixed(at(low), at(low + numbers_per_direction), share),
                                 mixed(at(high), at(high + numbers_per_direction), share),
                                 step.position.up_share);
                };
                light[band] += step.of_molecules[band] *
                                   (sun[band] * molecules + local[band] * there(by_molecules_)) +
                               step.of_aerosol[band] *
                                   (sun[band] * aerosol[band] + local[band] * there(by_aerosol_));
            }
        }
        all.push_back(light);
    }
    return all;
}

}  // namespace fumon
