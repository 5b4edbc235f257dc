#include "python/geo_references.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/spatial_reference.h"

namespace fumon::python {

namespace {

std::string wkt_of(const std::string& crs) {
    if (crs.empty() || crs.find('[') != std::string::npos) return crs;
    if (!has_gdal()) {
        throw InputError(
            fmt::format("to read the reference system \"{}\", fumon {}", crs, missing_gdal()));
    }
    const SpatialReference system(crs);
    if (!system.understood())
        throw InputError(fmt::format("the reference system \"{}\" is not known to PROJ", crs));
    return system.wkt();
}

}  // namespace

GeoReference geo_reference_of(const GeoReferenceTuple& place) {
    const auto& [west, south, dx, dy, degrees, crs] = place;
    return {west, south, dx, dy, degrees, wkt_of(crs)};
}

}  // namespace fumon::python
