#pragma once

#include <string>
#include <vector>

namespace fumon {

/// The marks of an axis or colour bar: round values within its range, and what stands beside them.
struct Ticks {
    std::vector<double> values;
    std::vector<std::string> labels;  ///< as many, with a true minus sign
};

/// The power of ten at or below a value > 0, or as little `above` it, within ±400: beyond all
/// doubles.
int power_below(double value, double above = 0.0);

/// 1, 2 or 5 times a power of ten.
struct RoundStep {
    int leading = 1;
    int exponent = 0;

    [[nodiscard]] double value() const;
};

/// The finest step of whose multiples no more than `most` (at least 2) lie within [low, high]. The
/// range is finite and not empty.
RoundStep round_step(double low, double high, int most);

/// The multiples of a step within [low, high].
std::vector<double> multiples(double step, double low, double high);

/// A number with so many decimals and a true minus sign.
std::string plain_number(double value, int decimals);

/// "10⁻³"
std::string power_of_ten(int exponent);

/// Marks at multiples of 1, 2 or 5 times a power of ten within [low, high]: the finest such step
/// that needs no more than `most` of them (at least 2). None for a range that is empty or not
/// finite.
Ticks linear_ticks(double low, double high, int most);

/// Marks at the whole powers of ten within [low, high], every n-th where they are more than `most`.
/// None unless 0 < low < high.
Ticks logarithmic_ticks(double low, double high, int most);

}  // namespace fumon
