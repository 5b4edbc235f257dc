#pragma once

#include <cmath>

namespace fumon {

/// The column or row of a periodic bed of `size` that lies at any whole number of sites.
inline int wrap_periodic(int value, int size) {
    const int rest = value % size;
    return rest < 0 ? rest + size : rest;
}

/// The same for a place between sites.
inline double wrap_periodic(double value, int size) {
    return value - size * std::floor(value / size);
}

}  // namespace fumon
