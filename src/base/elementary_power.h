#pragma once

#include "base/double_double.h"

/// Powers and decimal logarithms whose bits do not depend on the CPU, by logarithm and exponential
/// function in double-double arithmetic. Correctly rounded, subnormal results too, but where the
/// true value lies within 2^-85 of itself from the middle of two doubles (none in a million random
/// arguments); then off by less than 1 unit in the last place. About 4 µs: not for loops over
/// cells.
namespace fumon::elementary {

/// base^exponent, with the special values of IEEE 754 (which are those of std::pow).
double pow(double base, double exponent);

/// Logarithm to base 10: exact at powers of ten, −infinity at 0, not a number below.
double log10(double x);

}  // namespace fumon::elementary
