#pragma once

#include <optional>
#include <string_view>

namespace fumon {

/// Metres per unit of length as files name it ("m", "metres", "km", "cm", "mm", "feet", "ft" …, in
/// any case); nothing for what is no length.
std::optional<double> metres_per_unit(std::string_view unit);

/// Whether a unit is one of degrees ("degrees_north", "degree", "°" …).
bool is_degrees(std::string_view unit);

}  // namespace fumon
