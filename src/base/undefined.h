#pragma once

#include <limits>

namespace fumon {

/// What a measure is where a bed does not have it.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace fumon
