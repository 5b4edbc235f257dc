// Units as files write them, a row each.

#include "files/unit_conversion.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

namespace fumon::test {
namespace {

struct Length {
    const char* unit;
    double metres;
};

constexpr double us_foot = 1200.0 / 3937.0;

TEST(UnitConversion, KnowsEveryLengthOfUdunitsGdalAndProj) {
    constexpr std::array<Length, 52> lengths{{
        {"m", 1.0},
        {"M", 1.0},
        {"metre", 1.0},
        {"Meters", 1.0},
        {" metres ", 1.0},
        {"km", 1000.0},
        {"kilometre", 1000.0},
        {"KILOMETERS", 1000.0},
        {"dm", 0.1},
        {"cm", 0.01},
        {"centimeters", 0.01},
        {"mm", 0.001},
        {"micron", 1e-6},
        {"µm", 1e-6},
        {"0.1 m", 0.1},
        {"ft", 0.3048},
        {"Foot", 0.3048},
        {"feet", 0.3048},
        {"foot (International)", 0.3048},
        {"Foot_Intl", 0.3048},
        {"international_foot", 0.3048},
        {"US survey foot", us_foot},
        {"US survey feet", us_foot},
        {"US_survey_foot", us_foot},
        {"Foot_US", us_foot},
        {"us-ft", us_foot},
        {"ftUS", us_foot},
        {"US survey mile", 5280.0 * us_foot},
        {"us-mi", 5280.0 * us_foot},
        {"US survey chain", 66.0 * us_foot},
        {"US survey link", 0.66 * us_foot},
        {"yard", 0.9144},
        {"yd", 0.9144},
        {"in", 0.0254},
        {"inches", 0.0254},
        {"mile", 1609.344},
        {"mi", 1609.344},
        {"Statute mile", 1609.344},
        {"nautical mile", 1852.0},
        {"kmi", 1852.0},
        {"nautical_mile", 1852.0},
        {"chain", 20.1168},
        {"link", 0.201168},
        {"fathom", 1.8288},
        {"Foot_Clarke", 0.3047972654},
        {"Clarke's foot", 0.3047972654},
        {"British foot (Sears 1922)", 12.0 / 39.370147},
        {"Indian foot", 12.0 / 39.370142},
        {"Gold Coast foot", 6378300.0 / 20926201.0},
        {"German legal metre", 1.0000135965},
        {"light_year", 9.46073e15},
        {"astronomical_unit", 1.495979e11},
    }};
    for (const Length& length : lengths) {
        const auto metres = metres_per_unit(length.unit);
        ASSERT_TRUE(metres.has_value()) << length.unit;
        EXPECT_NEAR(*metres / length.metres, 1.0, length.metres > 1e6 ? 1e-5 : 1e-13)
            << length.unit;
    }
    EXPECT_EQ(metres_per_unit("Feet"), 0.3048) << "to the last bit";
    EXPECT_EQ(metres_per_unit("cm"), 0.01);
}

TEST(UnitConversion, RefusesWhatIsNoLength) {
    for (const char* unit : {"", "K", "m s-1", "m2", "m-1", "1", "degrees_north", "no such thing",
                             "m @ 100", "-1 m", "dB", "km/", "sites"})
        EXPECT_FALSE(metres_per_unit(unit).has_value()) << unit;
}

TEST(UnitConversion, HeightsMayNameTheirDatum) {
    EXPECT_EQ(metres_per_height(""), 1.0);
    EXPECT_EQ(metres_per_height("1"), 1.0);
    EXPECT_EQ(metres_per_height("m above sea level"), 1.0);
    EXPECT_EQ(metres_per_height("feet (NAVD88)"), 0.3048);
    EXPECT_EQ(metres_per_height("cm a.s.l."), 0.01);
    EXPECT_EQ(metres_per_height("foot (International)"), 0.3048);
    EXPECT_FALSE(metres_per_height("K above zero").has_value());
}

struct Row {
    const char* from;
    const char* to;
    double factor;
};

TEST(UnitConversion, ConvertsWater) {
    constexpr std::array<Row, 14> rows{{
        {"kg m-2 s-1", "mm h-1", 3600.0},
        {"kg/m^2/s", "mm h-1", 3600.0},
        {"m/s", "mm h-1", 3.6e6},
        {"m s-1", "mm h-1", 3.6e6},
        {"mm/h", "mm h-1", 1.0},
        {"mm/hr", "mm h-1", 1.0},
        {"mm hour-1", "mm h-1", 1.0},
        {"mm day-1", "mm h-1", 1.0 / 24.0},
        {"in/hr", "mm h-1", 25.4},
        {"cm", "m", 0.01},
        {"mm", "m", 0.001},
        {"kg m-2", "m", 0.001},
        {"km/h", "m s-1", 1.0 / 3.6},
        {"percent", "1", 0.01},
    }};
    for (const Row& row : rows) {
        const auto conversion = water_conversion(row.from, row.to);
        ASSERT_TRUE(conversion.has_value()) << row.from;
        EXPECT_NEAR((*conversion)(2.0), 2.0 * row.factor, 1e-13 * row.factor) << row.from;
    }
    for (const char* no_rate : {"mm", "kg m-2", "h mm-1", "s m-1", "K", "mm2/h"})
        EXPECT_FALSE(water_conversion(no_rate, "mm h-1").has_value()) << no_rate;
}

TEST(UnitConversion, OffsetsCount) {
    EXPECT_NEAR((*unit_conversion("m @ 100", "m"))(5.0), 105.0, 1e-12);
}

TEST(UnitConversion, IsSafeInThreads) {
    std::vector<std::thread> threads;
    std::array<bool, 4> good{};
    for (bool& one : good) {
        threads.emplace_back([&one] {
            one = true;
            for (int k = 0; k < 200; ++k)
                one = one && metres_per_unit(k % 2 == 0 ? "km" : "US survey foot").has_value();
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const bool one : good) EXPECT_TRUE(one);
}

TEST(UnitConversion, DegreesAreKnown) {
    for (const char* unit : {"degrees_east", "degree", "deg", "°", "Degrees_North", "degreeE"})
        EXPECT_TRUE(is_degrees(unit)) << unit;
    for (const char* unit : {"m", "1", "", "rad"}) EXPECT_FALSE(is_degrees(unit)) << unit;
}

}  // namespace
}  // namespace fumon::test
