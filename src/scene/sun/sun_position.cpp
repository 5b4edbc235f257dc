#include "scene/sun/sun_position.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/units.h"

namespace fumon {

namespace {

double sin_of(double degrees) {
    return elementary::sin(degrees * degree);
}

double cos_of(double degrees) {
    return elementary::cos(degrees * degree);
}

/// 0 … 360.
double within_a_turn(double degrees) {
    return degrees - 360.0 * std::floor(degrees / 360.0);
}

/// Of an elevation without air, degrees: 34′ at the horizon.
double refraction(double elevation) {
    constexpr double whole_from = -1.0;
    constexpr double none_below = -4.0;
    const double from = std::max(elevation, whole_from);
    const double angle = (from + 10.3 / (from + 5.11)) * degree;
    const double raised = 1.02 / 60.0 * elementary::cos(angle) / elementary::sin(angle);
    const double share = (elevation - none_below) / (whole_from - none_below);
    return std::max(raised, 0.0) * std::clamp(share, 0.0, 1.0);
}

}  // namespace

SkyPosition sun_position(double latitude, double longitude, double days) {
    constexpr double parallax = 8.794 / 3600.0;
    const double t = days / 36525.0;  // Julian centuries

    // Ecliptic longitude: mean longitude, equation of the centre, nutation and aberration.
    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = within_a_turn(357.52911 + t * (35999.05029 - t * 0.0001537));
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sin_of(anomaly) +
                          (0.019993 - t * 0.000101) * sin_of(2.0 * anomaly) +
                          0.000289 * sin_of(3.0 * anomaly);
    const double node = within_a_turn(125.04 - 1934.136 * t);
    const double nutation = -0.00478 * sin_of(node);
    const double lambda = within_a_turn(mean_longitude + centre - 0.00569 + nutation);
    const double mean_obliquity =
        23.0 + (26.0 + (21.448 - t * (46.815 + t * (0.00059 - t * 0.001813))) / 60.0) / 60.0;
    const double obliquity = mean_obliquity + 0.00256 * cos_of(node);

    // Towards the equator's axes, and hour angle from the sidereal time at Greenwich.
    const double across = cos_of(obliquity) * sin_of(lambda);
    const double right_ascension = elementary::atan2(across, cos_of(lambda)) / degree;
    const double sin_declination = sin_of(obliquity) * sin_of(lambda);
    const double cos_declination = elementary::hypot(across, cos_of(lambda));
    const double sidereal = within_a_turn(280.46061837 + 360.98564736629 * days +
                                          t * t * 0.000387933 + nutation * cos_of(obliquity));
    const double hour_angle = within_a_turn(sidereal + longitude - right_ascension);

    const double north = sin_declination * cos_of(latitude) -
                         cos_declination * cos_of(hour_angle) * sin_of(latitude);
    const double east = -cos_declination * sin_of(hour_angle);
    const double up = sin_declination * sin_of(latitude) +
                      cos_declination * cos_of(hour_angle) * cos_of(latitude);
    const double level = elementary::hypot(north, east);
    const double geocentric = elementary::atan2(up, level) / degree;
    const double true_elevation = geocentric - parallax * level;
    return {within_a_turn(elementary::atan2(east, north) / degree),
            std::min(true_elevation + refraction(true_elevation), 90.0)};
}

}  // namespace fumon
