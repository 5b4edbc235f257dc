#pragma once

#include <cstddef>
#include <string>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

enum class AxisUnit {
    metres,   ///< a length, converted to metres
    degrees,  ///< of longitude or latitude
    sites,    ///< a pure number ("1")
    unsaid    ///< none given
};

/// A horizontal dimension of a variable and its coordinates.
struct NetcdfAxis {
    std::string name;
    std::size_t count = 0;
    bool has_coordinates = false;
    bool descending = false;
    double lowest = 0.0;   ///< the smallest coordinate: a cell's centre
    double spacing = 0.0;  ///< greater than 0; 0 for a single cell or without coordinates
    AxisUnit unit = AxisUnit::unsaid;
};

/// Reads a dimension's coordinate variable (the one-dimensional variable of the same name). The
/// coordinates must be evenly spaced: each may stand off the even line between first and last by
/// 1e-6 of the way between these, and by what single precision rounds where they are stored so. The
/// spacing of double-precision coordinates is rounded to 12 digits, so that cells of 0.1 m read as
/// 0.1 m. Throws InputError for uneven, equal or missing coordinates and for a unit that is neither
/// a length nor degrees, NetcdfFault where the library fails.
NetcdfAxis read_netcdf_axis(const NetcdfInput& input, int dimension);

/// Whether a dimension's name or its coordinates' attributes call it eastward (x, lon …).
bool says_eastward(const NetcdfInput& input, int dimension);
/// Likewise northward (y, lat …).
bool says_northward(const NetcdfInput& input, int dimension);
/// Likewise a time or a height, no side of a map.
bool says_not_horizontal(const NetcdfInput& input, int dimension);

}  // namespace fumon
