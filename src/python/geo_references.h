#pragma once

#include <string>
#include <tuple>

#include "base/geo_reference.h"

namespace fumon::python {

/// West, south, dx and dy in the coordinates' own unit, whether that is degrees, and their system:
/// WKT, or "EPSG:32613" and the like.
using GeoReferenceTuple = std::tuple<double, double, double, double, bool, std::string>;

/// Throws InputError where the system is not WKT and there is no GDAL to know it, or PROJ does not.
GeoReference geo_reference_of(const GeoReferenceTuple& place);

}  // namespace fumon::python
