#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/sky/atmosphere.h"

namespace fumon {

/// Colours over a rectangle, looked up between their centres linearly.
class LightTable {
  public:
    LightTable(int columns, int rows)
        : columns_(columns),
          rows_(rows),
          colours_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] glm::dvec3& at(int column, int row) { return colours_[index(column, row)]; }
    [[nodiscard]] const glm::dvec3& at(int column, int row) const {
        return colours_[index(column, row)];
    }
    /// x and y from 0 to 1, from the first centre to the last.
    [[nodiscard]] glm::dvec3 value(double x, double y) const;

  private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    int columns_;
    int rows_;
    std::vector<glm::dvec3> colours_;
};

/// What an atmosphere does wherever the sun stands (Hillaire 2020, "A scalable and production ready
/// sky and atmosphere rendering technique"): transmittance by the parameters of Bruneton & Neyret
/// (2008), and light scattered more than once, taken as isotropic. Against photons walked through
/// the same air the sky is up to 11 % too dark (blue, sun at 8°), with a high sun 8 %.
class AirTables {
  public:
    explicit AirTables(const Atmosphere& air);

    [[nodiscard]] const Atmosphere& air() const { return air_; }

    /// Of the air from a point to the top, along a ray with a cosine `up` of its zenith angle; 0
    /// for rays that end on the ground.
    [[nodiscard]] glm::dvec3 transmittance(double radius, double up) const;

    /// The radiance that multiple scattering adds at a point for each unit of scattering there,
    /// with the sun of irradiance 1 at a cosine of its zenith angle.
    [[nodiscard]] glm::dvec3 multiple_scattering(double radius, double sun_up) const;

    /// The radiance that comes from a direction in the air to a point, for a sun of irradiance 1.
    /// `up`, `sun_up`: cosines of the zenith angles of view and sun; `towards_sun`: the cosine of
    /// the angle between them. What the ground sends is left out.
    [[nodiscard]] glm::dvec3 radiance(double radius, double up, double sun_up,
                                      double towards_sun) const;

  private:
    void tabulate_transmittance();
    void tabulate_multiple_scattering();

    Atmosphere air_;
    LightTable transmittance_;
    LightTable multiple_scattering_;
};

/// The clear sky over level ground for one place of the sun, irradiance of the sun above the air 1:
/// radiances over the upper half of all directions.
class SkyView {
  public:
    /// `sun_elevation` in radians above the horizon, at least −0.3; `eye_height` in km. `aureole`:
    /// angle from the sun, radians, within which the sky counts as the sun's aureole, and not among
    /// what irradiances are of.
    SkyView(const AirTables& air, double sun_elevation, double eye_height, double aureole = 0.0);

    /// From a direction: elevation above the horizon (0 … π/2) and azimuth from the sun's (0 … π).
    [[nodiscard]] glm::dvec3 radiance(double elevation, double azimuth) const;

    /// The sunlight that reaches the ground, on a surface that faces it.
    [[nodiscard]] const glm::dvec3& sun() const { return sun_; }
    /// What the sky within the aureole gives a surface that faces the sun. What hides the sun
    /// hides that too.
    [[nodiscard]] const glm::dvec3& aureole() const { return aureole_; }
    /// What the sky besides gives level ground.
    [[nodiscard]] const glm::dvec3& level_irradiance() const { return level_irradiance_; }
    /// What it gives a slope with a normal, `toward_sun` along the sun's azimuth, `up` ≥ 0 and the
    /// rest across it, where nothing hides the sky.
    [[nodiscard]] glm::dvec3 irradiance(double toward_sun, double up) const;
    /// Radiances, along the columns the square root of the azimuth from the sun (0 … √π), along the
    /// rows that of the elevation (0 … √(π/2)).
    [[nodiscard]] const LightTable& table() const { return table_; }

  private:
    /// Light of a part of the sky, on a surface that faces it.
    struct SkyPatch {
        double toward_sun;
        double across;
        double up;
        glm::dvec3 light;
    };

    LightTable table_;
    std::vector<SkyPatch> parts_;  // of one half of the sky; the other is its mirror image
    glm::dvec3 sun_{0.0};
    glm::dvec3 aureole_{0.0};
    glm::dvec3 level_irradiance_{0.0};
};

}  // namespace fumon
