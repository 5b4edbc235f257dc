#include "scene/sun/utc_time.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace fumon {
namespace {

TEST(UtcTime, CountsDaysFromTheNoonOfTheFirstOfJanuary2000) {
    EXPECT_EQ(days_from_2000("2000-01-01T12:00Z"), 0.0);
    EXPECT_EQ(days_from_2000("2000-01-02T00:00:00Z"), 0.5);
    EXPECT_EQ(days_from_2000("2000-02-29T12:00Z"), 59.0);
    EXPECT_EQ(days_from_2000("2000-03-01T12:00Z"), 60.0);
    // Julian day numbers of Meeus (1998), page 62, minus 2451545.
    EXPECT_EQ(days_from_2000("1999-01-01T00:00Z"), 2451179.5 - 2451545.0);
    EXPECT_EQ(days_from_2000("1987-01-27T00:00Z"), 2446822.5 - 2451545.0);
    EXPECT_EQ(days_from_2000("1988-06-19T12:00Z"), 2447332.0 - 2451545.0);
    EXPECT_NEAR(days_from_2000("2003-10-17T12:30:30-07:00"), 2452930.312847 - 2451545.0, 1e-6);
}

TEST(UtcTime, TakesOffsetsAndFractionsOfSeconds) {
    const double utc = days_from_2000("2026-03-20T06:40:00Z");
    for (const char* same : {"2026-03-20T06:40+00:00", "2026-03-20 06:40z", "2026-03-20T12:10+0530",
                             "2026-03-19T23:40:00.0-07", "2026-03-20T15:40+09:00"})
        EXPECT_NEAR(days_from_2000(same), utc, 1e-11) << same;
    EXPECT_NEAR(days_from_2000("2026-03-20T06:40:30.5Z") - utc, 30.5 / 86400.0, 1e-11);
}

TEST(UtcTime, RefusesWhatIsNoTime) {
    for (const char* bad : {"",
                            "2026",
                            "2026-03-20",
                            "2026-03-20T06:40",
                            "2026-03-20T06:40+",
                            "2026-03-20T6:40Z",
                            "2026-3-20T06:40Z",
                            "2026-03-20T06:40Zulu",
                            "2026-03-20T06:40+15",
                            "2026-03-20T06:40+0",
                            "2026-03-20T06:40.5Z",
                            "2026-03-20T06:40:10.Z",
                            "20.3.2026 6:40",
                            "2026-03-20T06:40+05:60",
                            "2026-02-29T06:40Z",
                            "2026-04-31T06:40Z",
                            "2026-00-10T06:40Z",
                            "2026-13-10T06:40Z",
                            "2026-03-00T06:40Z",
                            "2026-03-20T24:00Z",
                            "2026-03-20T06:60Z",
                            "2026-03-20T06:40:60Z",
                            "1900-03-20T06:40Z",
                            "2100-03-20T06:40Z"})
        EXPECT_THROW(days_from_2000(bad), InputError) << bad;
}

}  // namespace
}  // namespace fumon
