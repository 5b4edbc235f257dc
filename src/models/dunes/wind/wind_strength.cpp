#include "models/dunes/wind/wind_strength.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/error.h"
#include "base/units.h"

namespace fumon {

namespace {

void check_given_once(const DuneWind& wind, std::size_t number) {
    const auto refuse = [&](const char* key, const std::string& fault) {
        throw KeyError(fmt::format("wind.{}.{}", number, key), fault);
    };
    if (!wind.speed.is_word() && !wind.friction_velocity.is_word())
        refuse("friction_velocity", "speed and friction_velocity give the same quantity; keep one");
    if (wind.is_measured() && wind.strength != DuneWind{}.strength) {
        refuse("strength",
               fmt::format("strength = {:g} beside a {}, from which the drift follows; "
                           "keep one",
                           wind.strength, wind.speed.is_word() ? "friction_velocity" : "speed"));
    }
}

/// u* of a wind, m/s.
double friction_velocity_of(const DuneWind& wind, std::size_t number, const SandAndAir& with) {
    if (!wind.friction_velocity.is_word()) return wind.friction_velocity.value;
    if (wind.speed_height <= with.roughness) {
        throw KeyError(fmt::format("wind.{}.speed_height", number),
                       fmt::format("speeds {:g} m above the ground lie within model.roughness = "
                                   "{:g} m; write the height of the anemometer",
                                   wind.speed_height, with.roughness));
    }
    return friction_velocity(with, wind.speed.value, wind.speed_height);
}

}  // namespace

SandAndAir sand_and_air_of(const DunesParameters& parameters) {
    SandAndAir with;
    with.grain_diameter = parameters.grain_diameter * metres_per_millimetre;
    with.roughness = parameters.roughness;
    return with;
}

DunesParameters with_wind_strengths(const DunesParameters& parameters) {
    DunesParameters resolved = parameters;
    const SandAndAir with = sand_and_air_of(parameters);
    const double threshold = impact_threshold(with);
    const bool has_threshold = parameters.transport == DuneTransport::continuous &&
                               parameters.speed_up == DuneSpeedUp::relief;
    for (std::size_t n = 0; n < resolved.winds.size(); ++n) {
        DuneWind& wind = resolved.winds[n];
        check_given_once(wind, n);
        const bool is_automatic = wind.threshold_ratio.word == "auto";
        if (is_automatic) wind.threshold_ratio = {"none", 0.0};
        if (!wind.is_measured()) continue;
        const double velocity = friction_velocity_of(wind, n, with);
        wind.strength = yearly_flux(with, velocity) / parameters.flux;
        if (wind.strength > 0.0 && is_automatic && has_threshold)
            wind.threshold_ratio = velocity / threshold;
        if (wind.strength == 0.0 && parameters.transport == DuneTransport::slabs) {
            throw KeyError(
                fmt::format("wind.{}.{}", n, wind.speed.is_word() ? "friction_velocity" : "speed"),
                fmt::format("u* = {:.3g} m/s moves no sand (the threshold is {:.3g}), "
                            "and slabs hop until sand has moved; leave the wind out",
                            velocity, threshold));
        }
    }
    return resolved;
}

double strongest_wind(const DunesParameters& parameters) {
    double strongest = 0.0;
    for (const DuneWind& wind : parameters.winds) strongest = std::max(strongest, wind.strength);
    const bool all_measured = std::ranges::all_of(parameters.winds, &DuneWind::is_measured);
    return strongest > 0.0 && all_measured ? strongest : std::max(strongest, 1.0);
}

}  // namespace fumon
