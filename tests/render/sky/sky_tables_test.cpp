#include "render/sky/sky_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "render/sky/desert_aerosol.h"

namespace fumon {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double eye = 0.002;  // km

const AirTables& earth() {
    static const AirTables tables{Atmosphere{}};
    return tables;
}

/// 8 km of Rayleigh scattering, 1.2 km of aerosol and 15 km of ozone, at sea level's strength.
TEST(AirTables, TheZenithIsAsClearAsTheColumnsSay) {
    const glm::dvec3 expected(0.94036, 0.86762, 0.76231);
    const glm::dvec3 found = earth().transmittance(6360.0, 1.0);
    for (int band = 0; band < 3; ++band) EXPECT_NEAR(found[band], expected[band], 4e-4) << band;
}

TEST(AirTables, NothingPassesTheGround) {
    EXPECT_EQ(earth().transmittance(6360.5, -0.1), glm::dvec3(0.0));
    EXPECT_GT(earth().transmittance(6360.5, 0.0).r, 0.0);
    EXPECT_GT(earth().transmittance(6459.9, 1.0).b, 0.9999);
}

TEST(MiePhase, IsOneOverAllDirections) {
    double mie = 0.0;
    double rayleigh = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double cosine = -1.0 + 2.0 * (i + 0.5) / steps;
        mie += mie_phase(cosine, 0.8) * 4.0 * pi / steps;
        rayleigh += rayleigh_phase(cosine) * 4.0 * pi / steps;
    }
    EXPECT_NEAR(mie, 1.0, 1e-4);
    EXPECT_NEAR(rayleigh, 1.0, 1e-6);
}

/// That of the background desert aerosol of d'Almeida, Koepke & Shettle (1991) at 550 nm, as the
/// code 6S has it: times 4π, at scattering angles in degrees.
TEST(AerosolPhase, OfADesertIsThatOfItsAerosol) {
    const Atmosphere air = desert_air(1.0, glm::dvec3(0.3));
    const std::array<std::array<double, 2>, 8> published{{{10.0, 10.5},
                                                          {20.0, 6.48},
                                                          {30.0, 3.84},
                                                          {45.0, 1.75},
                                                          {60.0, 0.836},
                                                          {90.0, 0.263},
                                                          {120.0, 0.155},
                                                          {150.0, 0.192}}};
    for (const auto& [angle, expected] : published) {
        const double found = 4.0 * pi * aerosol_phase(air, 1, std::cos(angle * pi / 180.0));
        EXPECT_NEAR(found / expected, 1.0, 0.24) << angle;
    }
    double whole = 0.0;
    double along = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double cosine = -1.0 + 2.0 * (i + 0.5) / steps;
        const double share = aerosol_phase(air, 1, cosine) * 4.0 * pi / steps;
        whole += share;
        along += cosine * share;
    }
    EXPECT_NEAR(whole, 1.0, 1e-4);
    EXPECT_NEAR(along, 0.665, 0.01) << "the published mean cosine";
}

/// Photons walked backwards from the eye through the same air, in one band, any number of times
/// scattered: what the tables approximate.
class Walk {
  public:
    Walk(const AirTables& tables, int band, double sun_elevation)
        : tables_(tables),
          air_(tables.air()),
          band_(band),
          to_sun_(std::cos(sun_elevation), 0.0, std::sin(sun_elevation)) {}

    double radiance(double elevation, double azimuth, int paths) {
        double sum = 0.0;
        for (int i = 0; i < paths; ++i) {
            sum += path({std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation)});
        }
        return sum / paths;
    }

  private:
    double path(glm::dvec3 direction) {
        glm::dvec3 position(0.0, 0.0, air_.ground + eye);
        double weight = 1.0;
        double sum = 0.0;
        const double most = air_.optics(0.0).extinction()[band_];
        for (int bounce = 0; bounce < 40; ++bounce) {
            const double radius = glm::length(position);
            const RayEnd end = end_of_ray(air_, radius, glm::dot(position, direction) / radius);
            double distance = 0.0;
            bool scattered = false;
            AirOptics optics;
            while (true) {  // delta tracking
                distance -= std::log(1.0 - random_.uniform()) / most;
                if (distance >= end.distance) break;
                optics = air_.optics(glm::length(position + distance * direction) - air_.ground);
                if (random_.uniform() * most < optics.extinction()[band_]) {
                    scattered = true;
                    break;
                }
            }
            if (!scattered) {
                // Of the sky only what the air sends is asked for: ground seen directly is left
                // out.
                if (!end.on_ground || bounce == 0) return sum;
                position += end.distance * direction;
                const glm::dvec3 normal = glm::normalize(position);
                weight *= air_.ground_albedo[band_];
                sum += weight * std::max(glm::dot(normal, to_sun_), 0.0) / pi * sunlight(position);
                direction = glm::normalize(normal + sphere());
                position = normal * (air_.ground + 1e-6);
                continue;
            }
            position += distance * direction;
            weight *= optics.scattering()[band_] / optics.extinction()[band_];
            const double rayleigh = optics.rayleigh[band_] / optics.scattering()[band_];
            const double towards_sun = glm::dot(direction, to_sun_);
            sum += weight * sunlight(position) *
                   (rayleigh * rayleigh_phase(towards_sun) +
                    (1.0 - rayleigh) * aerosol_phase(air_, band_, towards_sun));
            const glm::dvec3 next = sphere();
            const double cosine = glm::dot(direction, next);
            weight *= 4.0 * pi *
                      (rayleigh * rayleigh_phase(cosine) +
                       (1.0 - rayleigh) * aerosol_phase(air_, band_, cosine));
            direction = next;
            if (weight < 0.02) {
                if (random_.uniform() > 0.5) return sum;
                weight *= 2.0;
            }
        }
        return sum;
    }

    double sunlight(const glm::dvec3& position) const {
        const double radius = std::max(glm::length(position), air_.ground + 1e-6);
        return tables_.transmittance(radius, glm::dot(position, to_sun_) / radius)[band_];
    }

    glm::dvec3 sphere() {
        const double up = 2.0 * random_.uniform() - 1.0;
        const double turn = 2.0 * pi * random_.uniform();
        const double across = std::sqrt(1.0 - up * up);
        return {across * std::cos(turn), across * std::sin(turn), up};
    }

    const AirTables& tables_;
    const Atmosphere& air_;
    int band_;
    glm::dvec3 to_sun_;
    RandomStream random_{1, 0, 0, Purpose::initial_bed};
};

TEST(SkyView, IsAsBrightAsPhotonsMakeIt) {
    for (const double sun : {45.0, 8.0}) {
        const SkyView sky(earth(), sun * pi / 180.0, eye);
        for (const int band : {0, 2}) {
            Walk walk(earth(), band, sun * pi / 180.0);
            for (const double elevation : {80.0, 20.0}) {
                const double expected = walk.radiance(elevation * pi / 180.0, 2.0, 30000);
                const double found = sky.radiance(elevation * pi / 180.0, 2.0)[band];
                EXPECT_NEAR(found / expected, 1.0, 0.13)
                    << "sun " << sun << ", view " << elevation << ", band " << band;
            }
        }
    }
}

/// Light is followed by its direction, without which the horizon away from the sun is 12 % too dark
/// and that below the sun as much too bright.
TEST(SkyView, IsAsBrightAsPhotonsMakeItOverADesert) {
    const AirTables air(desert_air(1.0, glm::dvec3(0.42, 0.30, 0.18)));
    for (const double sun : {45.0, 10.0}) {
        const SkyView sky(air, sun * pi / 180.0, eye);
        for (const double azimuth : {0.35, 2.0}) {
            for (const double elevation : {80.0, 20.0, 6.0, 1.2}) {
                const int band = elevation > 10.0 ? 2 : 0;
                Walk walk(air, band, sun * pi / 180.0);
                const double expected = walk.radiance(elevation * pi / 180.0, azimuth, 20000);
                const double found = sky.radiance(elevation * pi / 180.0, azimuth)[band];
                EXPECT_NEAR(found / expected, 1.0, 0.08)
                    << "sun " << sun << ", view " << elevation << ", " << azimuth;
            }
        }
    }
}

/// Light is moved from the sky to the sun, not lost.
TEST(SkyView, TheAureoleIsNotAmongTheSky) {
    const AirTables air(desert_air(1.0, glm::dvec3(0.3)));
    const double sun = 0.6;
    const SkyView whole(air, sun, eye);
    const SkyView parted(air, sun, eye, 0.3);
    EXPECT_EQ(whole.aureole(), glm::dvec3(0.0));
    for (int band = 0; band < 3; ++band) {
        const double moved = whole.level_irradiance()[band] - parted.level_irradiance()[band];
        EXPECT_GT(moved, 0.1 * whole.level_irradiance()[band]) << band;
        // Spread over a disc, it meets level ground a little less aslant than the sun.
        EXPECT_NEAR(parted.aureole()[band] * std::sin(sun) / moved, 1.0, 0.06) << band;
    }
}

TEST(SkyView, SlopesGetTheSkyTheyFace) {
    const AirTables air(dusty_air(3.0, glm::dvec3(0.3)));
    const SkyView sky(air, 0.15, 0.002);
    EXPECT_EQ(sky.irradiance(0.0, 1.0), sky.level_irradiance());
    const double tilt = 0.5;
    const glm::dvec3 toward = sky.irradiance(std::sin(tilt), std::cos(tilt));
    const glm::dvec3 away = sky.irradiance(-std::sin(tilt), std::cos(tilt));
    const glm::dvec3 across = sky.irradiance(0.0, std::cos(tilt));
    for (int band = 0; band < 3; ++band) {
        EXPECT_GT(toward[band], across[band]);
        EXPECT_GT(across[band], away[band]);
        EXPECT_GT(away[band], 0.2 * sky.level_irradiance()[band]);
    }
    EXPECT_GT(away.b / away.r, 1.5 * toward.b / toward.r) << "bluer away from the sun";
}

}  // namespace
}  // namespace fumon
