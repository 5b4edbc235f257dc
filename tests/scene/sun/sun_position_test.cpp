#include "scene/sun/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/sun/utc_time.h"

namespace fumon {
namespace {

SkyPosition sun_seen_from(double latitude, double longitude, const std::string& time) {
    return sun_position(latitude, longitude, days_from_2000(time));
}

/// The highest or lowest elevation of a day, minute by minute.
template <class Better>
double extreme_height(double latitude, const std::string& day, Better better) {
    const double start = days_from_2000(day + "T00:00Z");
    double found = sun_position(latitude, 0.0, start).elevation;
    for (int minute = 1; minute < 1440; ++minute)
        found = better(found, sun_position(latitude, 0.0, start + minute / 1440.0).elevation);
    return found;
}

double noon_height(double latitude, const std::string& day) {
    return extreme_height(latitude, day, [](double a, double b) { return std::max(a, b); });
}

double midnight_height(double latitude, const std::string& day) {
    return extreme_height(latitude, day, [](double a, double b) { return std::min(a, b); });
}

/// Reda & Andreas (2008), "Solar position algorithm for solar radiation applications", NREL
/// TP-560-34302, appendix 5: at 1830 m and 820 mbar, where air refracts by 0.004° less.
TEST(SunPosition, IsThatOfNrelsExample) {
    const SkyPosition sun = sun_seen_from(39.742476, -105.1786, "2003-10-17T12:30:30-07:00");
    EXPECT_NEAR(sun.azimuth, 194.34024, 0.01);
    EXPECT_NEAR(90.0 - sun.elevation, 50.11162, 0.01);
}

/// Meeus (1998), example 25.a: declination −7.78507° (apparent) on 1992-10-13 at 0 h dynamical
/// time; seen from the Earth's pole it is the elevation, which refraction does not reach there.
TEST(SunPosition, HasTheDeclinationOfMeeussExample) {
    const SkyPosition sun = sun_seen_from(-90.0, 0.0, "1992-10-12T23:59:01Z");
    const double refracted = 1.02 / 60.0 / std::tan((7.785 + 10.3 / (7.785 + 5.11)) * M_PI / 180.0);
    EXPECT_NEAR(sun.elevation, 7.78507 - 0.00242 + refracted, 0.002);
}

TEST(SunPosition, StandsOverTheEquatorAtTheEquinox) {
    // 2026-03-20 14:46 UTC; noon there is where it is then.
    const double noon_at = -15.0 * (14.0 + 46.0 / 60.0 - 12.0) + 7.5 / 60.0 * 15.0;
    EXPECT_GT(sun_seen_from(0.0, noon_at, "2026-03-20T14:46Z").elevation, 89.8);
    EXPECT_NEAR(noon_height(0.0, "2026-03-20"), 90.0, 0.15);
    // It rises in the east and sets in the west, everywhere on that day.
    for (const double latitude : {-50.0, -20.0, 20.0, 50.0}) {
        const double start = days_from_2000("2026-03-20T00:00Z");
        double rise = 0.0;
        double set = 0.0;
        for (int minute = 1; minute < 1440; ++minute) {
            const SkyPosition before = sun_position(latitude, 0.0, start + (minute - 1) / 1440.0);
            const SkyPosition now = sun_position(latitude, 0.0, start + minute / 1440.0);
            if (before.elevation < 0.0 && now.elevation >= 0.0) rise = now.azimuth;
            if (before.elevation >= 0.0 && now.elevation < 0.0) set = now.azimuth;
        }
        EXPECT_NEAR(rise, 90.0, 1.2) << latitude;
        EXPECT_NEAR(set, 270.0, 1.2) << latitude;
    }
}

TEST(SunPosition, IsByTheObliquityHigherAndLowerAtTheSolstices) {
    EXPECT_NEAR(noon_height(23.44, "2026-06-21"), 90.0, 0.15);
    EXPECT_NEAR(noon_height(50.0, "2026-06-21"), 40.0 + 23.436 + 0.010, 0.01);
    EXPECT_NEAR(noon_height(50.0, "2026-12-21"), 40.0 - 23.436 + 0.052, 0.01);
    EXPECT_NEAR(noon_height(-50.0, "2026-12-21"), 40.0 + 23.436 + 0.010, 0.01);
}

TEST(SunPosition, NeverRisesOrSetsBeyondThePolarCircle) {
    EXPECT_LT(noon_height(75.0, "2026-12-21"), -8.0);
    EXPECT_GT(midnight_height(75.0, "2026-06-21"), 8.0);
}

TEST(SunPosition, IsInTheNorthAtNoonInTheSouthernHemisphere) {
    const SkyPosition gobabeb = sun_seen_from(-23.56, 15.04, "2026-06-21T11:02Z");
    EXPECT_LT(std::min(gobabeb.azimuth, 360.0 - gobabeb.azimuth), 2.0);
    const SkyPosition tunis = sun_seen_from(36.8, 10.18, "2026-06-21T11:21Z");
    EXPECT_NEAR(tunis.azimuth, 180.0, 2.0);
    EXPECT_LT(sun_seen_from(-23.56, 15.04, "2026-06-21T08:00Z").azimuth, 90.0);
    EXPECT_GT(sun_seen_from(-23.56, 15.04, "2026-06-21T14:00Z").azimuth, 270.0);
}

TEST(SunPosition, IsRaisedByRefractionWithoutJumps) {
    const double start = days_from_2000("2026-03-20T12:20Z");
    double before = sun_position(30.0, 0.0, start).elevation;
    for (int i = 1; i < 21000; ++i) {  // until shortly before midnight, two seconds apart
        const double now = sun_position(30.0, 0.0, start + i / 43200.0).elevation;
        EXPECT_LT(now, before + 1e-4) << i;
        EXPECT_LT(std::abs(now - before), 0.012) << i;
        before = now;
    }
}

}  // namespace
}  // namespace fumon
