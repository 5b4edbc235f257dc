#pragma once

#include <string>

namespace fumon {

/// Where a grid lies on the Earth, in the unit of its coordinate reference system: metres, feet or
/// degrees. The grid's rows run east and its columns north (row 0 is the southernmost), whatever
/// the order in its file.
struct GeoReference {
    double west = 0.0;     ///< x of the grid's western edge
    double south = 0.0;    ///< y of the grid's southern edge
    double dx = 1.0;       ///< cell size eastward
    double dy = 1.0;       ///< cell size northward
    bool degrees = false;  ///< x is a longitude, y a latitude
    std::string crs{};     ///< the coordinate reference system as WKT; empty where it is unknown

    friend bool operator==(const GeoReference&, const GeoReference&) = default;
};

/// The coordinate reference system that is written for a grid in degrees whose file named none: it
/// says so, and takes the ellipsoid of WGS 84.
inline constexpr const char* degrees_of_unknown_datum =
    R"(GEOGCRS["degrees, datum not said",DATUM["not said, taken for WGS 84",)"
    R"(ELLIPSOID["WGS 84",6378137,298.257223563,LENGTHUNIT["metre",1]]],)"
    R"(PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]],CS[ellipsoidal,2],)"
    R"(AXIS["longitude",east,ORDER[1],ANGLEUNIT["degree",0.0174532925199433]],)"
    R"(AXIS["latitude",north,ORDER[2],ANGLEUNIT["degree",0.0174532925199433]]])";

}  // namespace fumon
