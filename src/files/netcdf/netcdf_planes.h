#pragma once

#include <optional>
#include <utility>

#include "files/netcdf/netcdf_axis.h"
#include "files/netcdf/netcdf_variable.h"

namespace fumon {

/// The axes of a variable whose coordinates are two-dimensional variables over its own y and x
/// (longitude and latitude, projected x and y), where they are a regular grid that is written so:
/// each column one x and each row one y, within a twentieth of a cell. Nothing where there are no
/// such coordinates. Throws InputError for a rotated or curvilinear grid, with its remedy.
std::optional<std::pair<NetcdfAxis, NetcdfAxis>> axes_of_planes(const NetcdfInput& input,
                                                                const BedVariable& bed);

}  // namespace fumon
