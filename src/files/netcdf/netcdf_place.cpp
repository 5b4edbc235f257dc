#include "files/netcdf/netcdf_place.h"

#include <netcdf.h>

#include <cmath>

#include "files/crs_kind.h"
#include "files/netcdf/grid_mapping.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_definition.h"

namespace fumon {

namespace {

constexpr const char* crs_name = "crs";

/// Whether a grid's place counts metres: as its scale does, or those of a projection, which need
/// not be the ground's.
bool counts_metres(const GeoReference& place, const WorldScale& scale) {
    constexpr double tolerance = 1e-6;
    const CrsKind kind = crs_kind(place.crs);
    if (kind.projected) return kind.metres == 1.0;
    return std::abs(place.dx / scale.dx - 1.0) < tolerance &&
           std::abs(place.dy / scale.dy - 1.0) < tolerance;
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

FilePlace place_in_file(const WorldScale& scale) {
    const bool lies = scale.in_metres && scale.place &&
                      (scale.place->degrees || counts_metres(*scale.place, scale));
    if (!lies) return {0.0, 0.0, scale.dx, scale.dy};
    const GeoReference& place = *scale.place;
    return {place.west, place.south,   place.dx,
            place.dy,   place.degrees, place.degrees || !place.crs.empty()};
}

void define_crs(int file, const WorldScale& scale) {
    int variable = 0;
    check_netcdf(nc_def_var(file, crs_name, NC_INT, 0, nullptr, &variable));
    put_text(file, variable, "long_name", "coordinate reference system");
    if (const auto mapping = mapping_of(*scale.place)) {
        put_text(file, variable, "grid_mapping_name", mapping->name);
        for (const auto& [name, values] : mapping->attributes)
            check_netcdf(nc_put_att_double(file, variable, name.c_str(), NC_DOUBLE, values.size(),
                                           values.data()));
    }
    if (scale.place->crs.empty()) return;
    put_text(file, variable, "crs_wkt", scale.place->crs);
    put_text(file, variable, "spatial_ref", scale.place->crs);
}

void put_grid_mapping(int file, int field, const WorldScale& scale) {
    if (mapping_of(*scale.place)) {
        put_text(file, field, "grid_mapping", crs_name);
    } else {
        put_text(file, field, "spatial_ref", scale.place->crs);
    }
}

}  // namespace fumon
