#pragma once

#include <cstdint>
#include <string>

namespace fumon {

/// "1,234,567".
std::string with_commas(std::int64_t number);

/// A number with so many decimals and commas between thousands: "1,234.50".
std::string with_commas(double number, int decimals);

}  // namespace fumon
