#pragma once

#include <cmath>

namespace fumon {

/// The column or row of a periodic bed of `size` that lies at any whole number of sites.
inline int into_box(int value, int size) {
    const int rest = value % size;
    return rest < 0 ? rest + size : rest;
}

/// The same for a place between sites.
inline double into_box(double value, int size) {
    return value - size * std::floor(value / size);
}

}  // namespace fumon
