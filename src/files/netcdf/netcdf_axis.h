#pragma once

#include <cstddef>
#include <string>
#include <vector>

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
    double metres = 1.0;  ///< per unit of the file, by which the coordinates were multiplied
};

/// By how much of a cell a coordinate may stand off the even line between first and last: what
/// single precision rounds longitudes to, at cells of a second of arc, and more.
inline constexpr double evenness = 0.05;

/// Reads a dimension's coordinates: the one-dimensional variable of the same name, else one over
/// the dimension that calls itself a coordinate (by its `axis`, standard name or unit). They must
/// be evenly spaced (`evenness`); the cell's size comes from first and last. That of
/// double-precision coordinates is rounded to 12 digits, so that cells of 0.1 m read as 0.1 m.
/// Throws InputError for uneven, equal or missing coordinates and for a unit that is neither a
/// length nor degrees, NetcdfFault where the library fails.
NetcdfAxis read_netcdf_axis(const NetcdfInput& input, int dimension);

/// The same of coordinates as they are stored in a variable, whose attributes say what they are.
NetcdfAxis netcdf_axis(const NetcdfInput& input, int variable, std::vector<double> coordinates);

/// Whether a variable holds longitudes or x by its standard name, unit or name.
bool is_eastward_variable(const NetcdfInput& input, int variable);
/// Likewise latitudes or y.
bool is_northward_variable(const NetcdfInput& input, int variable);

/// Whether a dimension's name or its coordinates' attributes call it eastward (x, lon …).
bool is_eastward(const NetcdfInput& input, int dimension);
/// Likewise northward (y, lat …).
bool is_northward(const NetcdfInput& input, int dimension);
/// Likewise a time or a height, no side of a map.
bool is_not_horizontal(const NetcdfInput& input, int dimension);

}  // namespace fumon
