#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// How numbers of one unit become numbers of another: number × factor + offset.
struct UnitConversion {
    double factor = 1.0;
    double offset = 0.0;

    [[nodiscard]] double operator()(double number) const { return number * factor + offset; }
};

/// From a unit as files write it to one in UDUNITS' syntax ("m", "mm h-1"); nothing where the first
/// is no unit that is known or measures something else. A unit's reciprocal is something else too.
/// Units are those of UDUNITS-2 in any case of letters, and what GDAL and PROJ call lengths ("US
/// survey foot", "Foot_US", "link" …). Safe in any thread. Throws Error where the database of
/// UDUNITS cannot be read.
std::optional<UnitConversion> unit_conversion(std::string_view from, std::string_view to);

/// The conversion of an amount or a rate of water: as unit_conversion(), and of masses over an area
/// ("kg m-2 s-1") by water's density, 1000 kg/m³.
std::optional<UnitConversion> water_conversion(std::string_view from, std::string_view to);

/// Metres per unit of length as files name it; nothing for what is no length.
std::optional<double> metres_per_unit(std::string_view unit);

/// Metres per unit of heights, which may name their datum ("m above sea level", "ft (NAVD88)") or
/// no unit ("", "1"): metres then. Nothing for what is no length.
std::optional<double> metres_per_height(std::string_view unit);

/// Whether a unit is one of degrees ("degrees_north", "degree", "°" …).
bool is_degrees(std::string_view unit);

}  // namespace fumon
