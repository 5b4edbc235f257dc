#include "figure/panels/axis_units.h"

namespace fumon {

LengthUnit length_unit(bool in_metres, double length) {
    constexpr double kilometre = 1e3;
    constexpr double millimetre = 1e-3;
    constexpr double rounding = 1e-9;
    if (!in_metres) return {};
    if (length >= 10.0 * kilometre * (1.0 - rounding)) return {kilometre, "km"};
    if (length < 1.0 - rounding) return {millimetre, "mm"};
    return {1.0, "m"};
}

LengthUnit height_unit(bool in_metres, double largest) {
    constexpr double small = 0.5;
    constexpr double millimetre = 1e-3;
    if (!in_metres) return {1.0, "model heights"};
    if (largest < small) return {millimetre, "mm"};
    return {1.0, "m"};
}

}  // namespace fumon
