#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/sky/sky_tables.h"

namespace fumon {

/// Light in the air over level ground under one sun, by successive orders of scattering: what comes
/// to a dozen heights from all directions, scattered there by molecules and aerosol as their phase
/// functions have it, on its way to the others, again and again, with ground that throws back what
/// sun and sky send it. The sun is as high over all points when light is scattered again; the
/// tables' isotropic light says how much more or less there is of it where it is not. Against
/// photons walked through the same air a desert's sky is within 6 %.
class ScatteredLight {
  public:
    /// `sun_elevation` in radians above the horizon. The tables have to outlive this.
    ScatteredLight(const AirTables& air, double sun_elevation);

    /// As AirTables::radiance, from directions of one elevation with azimuths from the sun's, 0 …
    /// π.
    [[nodiscard]] std::vector<glm::dvec3> radiances(double radius, double up,
                                                    const std::vector<double>& from) const;

  private:
    /// A number for each direction, band and height, the heights side by side.
    using Field = std::vector<double>;
    /// Where a point lies among the heights and directions up.
    struct GridPosition {
        int height;
        int up;
        double height_share;
        double up_share;
    };
    /// One step of a ray: where, and how much of the light scattered there arrives.
    struct PathStep {
        GridPosition position;
        double distance;
        double radius;
        glm::dvec3 of_molecules;
        glm::dvec3 of_aerosol;
        glm::dvec3 isotropic;  // light of the tables there
    };
    struct Path {
        std::vector<PathStep> steps;
        glm::dvec3 from_ground{0.0};  // share of its light that arrives, times its reflectance
    };

    [[nodiscard]] GridPosition grid_position(double height, double up) const;
    [[nodiscard]] double towards_sun(double up, double azimuth) const;
    [[nodiscard]] Path path_from(double radius, double up, int steps) const;
    [[nodiscard]] Field scattered_once(const std::vector<Path>& paths) const;
    /// Radiances out of what has been scattered, and what `ground` gets of the sky, over π.
    [[nodiscard]] Field arriving(const std::vector<Path>& paths, const Field& once,
                                 const glm::dvec3& ground) const;
    [[nodiscard]] glm::dvec3 on_ground(const Field& light) const;
    void scatter(const Field& light);
    void tabulate_phases();

    const AirTables& air_;
    double sun_up_;
    double sun_across_;
    std::vector<double> heights_;
    std::vector<double> phases_;  // between directions: of molecules, and of aerosol in each band
    Field by_molecules_;          // light scattered to a direction, per unit of scattering
    Field by_aerosol_;
};

}  // namespace fumon
