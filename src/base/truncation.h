#pragma once

namespace fumon {

/// A real number without its fraction, within [low, high]: beyond them the nearer end, `low` for
/// NaN. A plain conversion of what no int holds has no meaning in C++.
template <class Whole>
constexpr Whole truncated_within(double value, Whole low, Whole high) {
    if (!(value > static_cast<double>(low))) return low;
    return value < static_cast<double>(high) ? static_cast<Whole>(value) : high;
}

/// The same within ±2⁶².
constexpr long long truncated(double value) {
    constexpr long long most = 1LL << 62;
    return truncated_within(value, -most, most);
}

}  // namespace fumon
