#include "files/netcdf/netcdf_coordinates.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "files/crs_kind.h"
#include "files/netcdf/grid_mapping.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_definition.h"

namespace fumon {

namespace {

constexpr const char* crs_name = "crs";

/// The unit of a grid's place: that of a projection, whose metres need not be the ground's, or
/// metres where the place's cells are those of the scale. Empty: none that UDUNITS has a name for.
std::string unit_of_place(const GeoReference& place, const WorldScale& scale) {
    struct Length {
        const char* name;
        double metres;
    };
    constexpr std::array<Length, 4> known{
        {{"m", 1.0}, {"km", 1000.0}, {"US_survey_foot", 1200.0 / 3937.0}, {"foot", 0.3048}}};
    constexpr double rounding = 1e-9;  // feet of both kinds differ by 2e-6
    const CrsKind kind = crs_kind(place.crs);
    if (kind.projected) {
        const auto* found = std::ranges::find_if(known, [&](const Length& unit) {
            return std::abs(kind.metres / unit.metres - 1.0) < rounding;
        });
        return found == known.end() ? "" : found->name;
    }
    constexpr double tolerance = 1e-6;
    const bool in_metres = std::abs(place.dx / scale.dx - 1.0) < tolerance &&
                           std::abs(place.dy / scale.dy - 1.0) < tolerance;
    return in_metres ? "m" : "";
}

std::optional<GridMapping> mapping_of(const GeoReference& place) {
    auto mapping = grid_mapping_of(place.crs);
    if (place.degrees && (!mapping || mapping->name != "latitude_longitude")) {
        mapping.emplace();
        mapping->name = "latitude_longitude";
    }
    if (!place.degrees && mapping && mapping->name == "latitude_longitude") return std::nullopt;
    return mapping;
}

}  // namespace

FileCoordinates file_coordinates(const WorldScale& scale) {
    FileCoordinates from_corner{0.0, 0.0, scale.dx, scale.dy};
    if (!scale.in_metres || !scale.place) return from_corner;
    const GeoReference& place = *scale.place;
    const std::string unit = place.degrees ? "degrees" : unit_of_place(place, scale);
    if (unit.empty()) return from_corner;
    return {place.west,
            place.south,
            place.dx,
            place.dy,
            place.degrees,
            unit,
            place.degrees || !place.crs.empty()};
}

void define_crs(int file, const WorldScale& scale) {
    int variable = 0;
    check_netcdf(nc_def_var(file, crs_name, NC_INT, 0, nullptr, &variable));
    put_text(file, variable, "long_name", "coordinate reference system");
    if (const auto mapping = mapping_of(*scale.place)) {
        put_text(file, variable, "grid_mapping_name", mapping->name);
        const double metres = crs_kind(scale.place->crs).metres;
        for (auto [name, values] : mapping->attributes) {
            // By CF in the unit of the coordinates.
            if (name == "false_easting" || name == "false_northing") values.front() /= metres;
            check_netcdf(nc_put_att_double(file, variable, name.c_str(), NC_DOUBLE, values.size(),
                                           values.data()));
        }
    }
    if (scale.place->crs.empty()) return;
    put_text(file, variable, "crs_wkt", scale.place->crs);
    put_text(file, variable, "spatial_ref", scale.place->crs);
}

void put_grid_mapping(int file, int field) {
    put_text(file, field, "grid_mapping", crs_name);
}

}  // namespace fumon
