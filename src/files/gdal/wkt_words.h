#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// A coordinate reference system's WKT by its words alone, without PROJ: enough for the common
/// systems of .prj files.
struct WktWords {
    bool geographic = false;  ///< angles: GEOGCS, GEOGCRS, GEODCRS, also as a compound's first part
    bool projected = false;   ///< PROJCS, PROJCRS
    bool utm = false;         ///< by its name
    bool mercator = false;    ///< the cylinder that touches the equator, whose scale grows north
    double metres = 1.0;      ///< per unit of a projected system
    std::string unit{};       ///< of a projected system
};

/// Words of WKT 1, as .prj files and GDAL have it, or of WKT 2.
WktWords wkt_words(std::string_view wkt);

}  // namespace fumon
