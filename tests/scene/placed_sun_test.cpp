#include "scene/placed_sun.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "scene/read.h"
#include "scene/write.h"

namespace fumon {
namespace {

const std::string bare_dunes = "[model]\nname = \"dunes\"\n[run]\nsteps = 10\n";
const std::string placed_dunes =
    bare_dunes + "[sun]\nplace = [39.742476, -105.1786]\ntime = \"2003-10-17T12:30:30-07:00\"\n";

Scene dunes_of(const std::string& text, const std::vector<std::string>& settings = {}) {
    return parse_scene(text, "scene.toml", "", settings);
}

std::string sun_fault(const std::string& text, const std::vector<std::string>& settings = {}) {
    try {
        dunes_of(text, settings);
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "none";
}

TEST(PlacedSun, TakesAzimuthAndElevation) {
    const SunSettings sun = dunes_of(placed_dunes).view.sun;
    EXPECT_NEAR(sun.azimuth, 194.340, 0.01);
    EXPECT_NEAR(sun.elevation, 39.888, 0.01);
    EXPECT_EQ(dunes_of(bare_dunes).view.sun.azimuth, SunSettings{}.azimuth);
    EXPECT_EQ(dunes_of(bare_dunes).view.sun.elevation, SunSettings{}.elevation);
}

TEST(PlacedSun, TimesOfTomlNeedNoQuotes) {
    for (const char* time : {"2003-10-17T12:30:30-07:00", "2003-10-17 19:30:30Z"}) {
        const std::string text =
            bare_dunes + "[sun]\nplace = [39.742476, -105.1786]\ntime = " + time;
        EXPECT_NEAR(dunes_of(text + "\n").view.sun.azimuth, 194.340, 0.01) << time;
    }
    EXPECT_NE(sun_fault(bare_dunes + "[sun]\nplace = [1, 2]\ntime = 2003-10-17T12:30:30\n"),
              "none");
}

TEST(PlacedSun, ResolvedScenesAreReadAgain) {
    for (const std::string& text : {placed_dunes, placed_dunes + "hours = 2\n",
                                    placed_dunes + "[look]\npreset = \"golden-hour\"\n"}) {
        const std::string written = to_toml(dunes_of(text));
        EXPECT_EQ(to_toml(dunes_of(written)), written);
        // And may be placed_dunes elsewhere.
        EXPECT_GT(dunes_of(written, {"sun.time=2003-10-17T10:30-07:00"}).view.sun.elevation, 30.0);
    }
    const std::string standing = to_toml(dunes_of(bare_dunes + "[sun]\nazimuth = 33\n"));
    const std::vector<std::string> there{"sun.place=[39.7, -105.2]", "sun.time=2003-10-17T19:30Z"};
    EXPECT_NEAR(dunes_of(standing, there).view.sun.azimuth, 194.3, 0.2);
}

TEST(PlacedSun, WandersOverTheRun) {
    const SunSettings sun = dunes_of(placed_dunes + "hours = 2\n").view.sun;
    EXPECT_EQ(sun_at(sun, 0.0).azimuth, sun.azimuth);
    const SunSettings later =
        dunes_of(placed_dunes, {"sun.time=2003-10-17T14:30:30-07:00"}).view.sun;
    EXPECT_NEAR(sun_at(sun, 1.0).azimuth, later.azimuth, 1e-6);
    EXPECT_NEAR(sun_at(sun, 1.0).elevation, later.elevation, 1e-6);
    const SunSettings back = dunes_of(placed_dunes + "hours = -2\n").view.sun;
    EXPECT_LT(sun_at(back, 1.0).azimuth, back.azimuth);
    EXPECT_EQ(sun_at(SunSettings{}, 0.7).azimuth, SunSettings{}.azimuth);
    EXPECT_EQ(share_of_run(5, 10), 0.5);
    EXPECT_EQ(share_of_run(5, 0), 0.0);
    EXPECT_EQ(share_of_run(15, 10), 1.0);
}

TEST(PlacedSun, RefusesWhatDoesNotGoTogether) {
    EXPECT_EQ(sun_fault(placed_dunes), "none");
    EXPECT_EQ(sun_fault(bare_dunes + "[sun]\nplace = [1, 2]\n"),
              "scene.toml:6:9: sun.place needs sun.time, the time of the observation");
    EXPECT_EQ(
        sun_fault(bare_dunes + "[sun]\ntime = \"2003-10-17T12:30Z\"\n"),
        "scene.toml:6:8: sun.time needs sun.place, the [latitude, longitude] of the observation");
    EXPECT_EQ(sun_fault(bare_dunes + "[sun]\nhours = 3\n"),
              "scene.toml:6:9: sun.hours needs sun.place and sun.time");
    EXPECT_EQ(sun_fault(bare_dunes + "[sun]\nplace = [1]\ntime = \"2003-10-17T12:30Z\"\n"),
              "scene.toml:6:9: sun.place has 1 number; it takes [latitude, longitude]");
    EXPECT_EQ(
        sun_fault(bare_dunes + "[sun]\nplace = [-105.1786, 39.7]\ntime = \"2003-10-17T12:30Z\"\n"),
        "scene.toml:6:9: sun.place has the latitude -105.1786; it takes [latitude, longitude] with "
        "a latitude of -90 … 90");
    EXPECT_EQ(sun_fault(bare_dunes + "[sun]\nplace = [1, 2]\ntime = \"noon\"\n"),
              "scene.toml:7:8: sun.time: \"noon\" is not a time with its offset from UTC; write "
              "one as \"2026-03-20T06:40+00:00\" or \"2026-03-20T06:40Z\"");
    const std::string both =
        " and sun.place both set the sun's position; keep one of them (sun.place = [] and sun.time "
        "= \"\" clear the latter)";
    EXPECT_EQ(sun_fault(placed_dunes + "azimuth = 100\n"), "scene.toml:8:11: sun.azimuth" + both);
    EXPECT_EQ(sun_fault(placed_dunes + "elevation = 20\n"),
              "scene.toml:8:13: sun.elevation" + both);
    EXPECT_EQ(sun_fault(placed_dunes, {"sun.elevation=20"}), "--set 1:15: sun.elevation" + both);
    EXPECT_EQ(sun_fault(placed_dunes, {"sun.elevation=20", "sun.place=[]", "sun.time="}), "none");
    EXPECT_EQ(sun_fault(placed_dunes + "source = \"moon\"\n"),
              "scene.toml:8:10: sun.source = \"moon\" takes sun.azimuth and sun.elevation; "
              "sun.place and sun.time are for the sun only");
    EXPECT_EQ(sun_fault(placed_dunes + "[air]\nplanet = \"mars\"\n"),
              "scene.toml:9:10: sun.place and sun.time are for the Earth only; elsewhere take "
              "sun.azimuth and sun.elevation");
}

TEST(PlacedSun, RefusesNights) {
    EXPECT_EQ(sun_fault(placed_dunes, {"sun.time=2003-10-17T22:00-07:00"}),
              "--set 1:10: at sun.place and sun.time the sun stands 51.6 degrees below the "
              "horizon; it must stand at least 1 degree high");
    EXPECT_EQ(sun_fault(placed_dunes + "hours = 9\n"),
              "scene.toml:8:9: sun.hours is 9, but after 4.68 hours the sun is below 1 degree; "
              "take fewer, or begin at another sun.time");
    // Whole days are seen through.
    EXPECT_NE(sun_fault(placed_dunes + "hours = 24\n"), "none");
}

}  // namespace
}  // namespace fumon
