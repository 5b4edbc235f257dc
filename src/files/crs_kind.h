#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// What a coordinate reference system is by its well-known text alone, without PROJ.
struct CrsKind {
    bool geographic = false;  ///< it counts angles
    bool projected = false;
    bool utm = false;       ///< by its name
    bool mercator = false;  ///< Mercator's cylinder round the equator, whose scale grows poleward
    double metres = 1.0;    ///< per unit of a projected system
    std::string unit{};     ///< of a projected system: "US survey foot"
};

/// Reads WKT 1, as .prj files and GDAL have it, or WKT 2, of compound systems the horizontal part.
/// Nothing is known of a text that is neither.
CrsKind crs_kind(std::string_view wkt);

}  // namespace fumon
