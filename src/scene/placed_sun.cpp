#include "scene/placed_sun.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/error.h"
#include "scene/sun/sun_position.h"
#include "scene/sun/utc_time.h"

namespace fumon {

namespace {

constexpr double lowest_sun = 1.0;     // degrees, as sun.elevation
constexpr double nearly_there = 0.05;  // degrees: sun.azimuth and sun.elevation as they stand in
                                       // resolved scenes, maybe of another version
constexpr double look_every = 1.0 / 60.0;  // hours

SkyPosition place_after(const SunSettings& sun, double hours) {
    return sun_position(sun.place[0], sun.place[1], days_from_2000(sun.time) + hours / 24.0);
}

/// The signed angle from one azimuth to another, −180 … 180.
double turned(double from, double to) {
    return std::remainder(to - from, 360.0);
}

/// After how many of its hours the sun is first too low; none if it never is.
std::optional<double> too_low_after(const SunSettings& sun) {
    const auto looks = static_cast<int>(std::ceil(std::abs(sun.hours) / look_every));
    for (int i = 0; i <= looks; ++i) {
        const double hours = looks == 0 ? 0.0 : sun.hours * i / looks;
        if (place_after(sun, hours).elevation < lowest_sun) return hours;
    }
    return std::nullopt;
}

std::string height_text(double elevation) {
    return elevation < 0.0 ? fmt::format("{:.1f} degrees below the horizon", -elevation)
                           : fmt::format("{:.1f} degrees above the horizon", elevation);
}

/// Adds faults located at a key.
struct SunFaults {
    const Scene& scene;
    Faults& faults;
    void operator()(const std::string& key, const std::string& what) const {
        faults.add(InputError(scene.at(key) + what));
    }
};

/// The first of two that is not the scene's own default, for a message's place.
std::string either_given(const Scene& scene, const std::string& one, const std::string& other) {
    return scene.locations.contains(one) ? one : other;
}

/// Whether place and time are complete and sound by themselves.
bool check_place_and_time(const Scene& scene, const SunFaults& refuse) {
    const SunSettings& sun = scene.view.sun;
    if (sun.place.empty() && sun.time.empty()) {
        if (sun.hours != 0.0) refuse("sun.hours", "sun.hours needs sun.place and sun.time");
        return false;
    }
    if (sun.time.empty()) {
        refuse("sun.place", "sun.place needs sun.time, the time of the observation");
        return false;
    }
    if (sun.place.empty()) {
        refuse("sun.time",
               "sun.time needs sun.place, the [latitude, longitude] of the observation");
        return false;
    }
    if (sun.place.size() != 2) {
        refuse("sun.place", "sun.place has 1 number; it takes [latitude, longitude]");
        return false;
    }
    if (std::abs(sun.place[0]) > 90.0) {
        refuse("sun.place", fmt::format("sun.place has the latitude {}; it takes [latitude, "
                                        "longitude] with a latitude of -90 … 90",
                                        sun.place[0]));
        return false;
    }
    try {
        days_from_2000(sun.time);
    } catch (const InputError& fault) {
        refuse("sun.time", std::string("sun.time: ") + fault.what());
        return false;
    }
    return true;
}

/// What also says where the light comes from.
void check_contradictions(const Scene& scene, const SunFaults& refuse) {
    const SunSettings& sun = scene.view.sun;
    const SkyPosition there = place_after(sun, 0.0);
    const bool placed_later =
        scene.set_on_command_line("sun.place") || scene.set_on_command_line("sun.time");
    const auto check_alone = [&](const char* key, double off) {
        if (!scene.locations.contains(key) || std::abs(off) <= nearly_there) return;
        if (placed_later && !scene.set_on_command_line(key)) return;
        refuse(key, fmt::format("{} and sun.place both set the sun's position; keep one of them "
                                "(sun.place = [] and sun.time = \"\" clear the latter)",
                                key));
    };
    check_alone("sun.azimuth", turned(there.azimuth, sun.azimuth));
    check_alone("sun.elevation", sun.elevation - there.elevation);
    if (sun.source == LightSource::moon)
        refuse("sun.source",
               "sun.source = \"moon\" takes sun.azimuth and sun.elevation; sun.place and sun.time "
               "are for the sun only");
    if (scene.view.air.planet != Planet::earth)
        refuse("air.planet",
               "sun.place and sun.time are for the Earth only; elsewhere take sun.azimuth "
               "and sun.elevation");
}

}  // namespace

bool is_placed(const SunSettings& sun) {
    return !sun.place.empty() && !sun.time.empty();
}

SunSettings sun_at(const SunSettings& sun, double share) {
    SunSettings moved = sun;
    if (!is_placed(sun)) return moved;
    const SkyPosition there = place_after(sun, sun.hours * share);
    moved.azimuth = there.azimuth;
    moved.elevation = there.elevation;
    return moved;
}

double share_of_run(std::int64_t step, std::int64_t last_step) {
    if (last_step <= 0) return 0.0;
    return std::clamp(static_cast<double>(step) / static_cast<double>(last_step), 0.0, 1.0);
}

void check_sun(const Scene& scene, Faults& faults) {
    const SunFaults refuse{scene, faults};
    if (!check_place_and_time(scene, refuse)) return;
    check_contradictions(scene, refuse);
    const SunSettings& sun = scene.view.sun;
    const std::optional<double> low = too_low_after(sun);
    if (!low) return;
    if (*low == 0.0) {
        refuse(either_given(scene, "sun.time", "sun.place"),
               fmt::format("at sun.place and sun.time the sun stands {}; it must stand at least "
                           "{:.0f} degree high",
                           height_text(place_after(sun, 0.0).elevation), lowest_sun));
    } else {
        refuse("sun.hours", fmt::format("sun.hours is {}, but after {:.2f} hours the sun is below "
                                        "{:.0f} degree; take fewer, or begin at another sun.time",
                                        sun.hours, *low, lowest_sun));
    }
}

void place_sun(SunSettings& sun) {
    sun = sun_at(sun, 0.0);
}

}  // namespace fumon
