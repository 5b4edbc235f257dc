#pragma once

#include <limits>

namespace fumon {

/// The value of a measure that a bed does not have.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace fumon
