#include "measure/raster/raster_quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "base/snapshot_lookup.h"
#include "measure/network/flow_routing.h"
#include "measure/raster/wetness_index.h"

namespace fumon {

namespace {

bool always(const RasterSource&) {
    return true;
}

bool has_depth(const RasterSource& source) {
    return field_of(source.snapshot.fields, "water_depth") != nullptr;
}

bool has_velocity(const RasterSource& source) {
    return has_depth(source) && field_of(source.snapshot.fields, "velocity_x") != nullptr &&
           field_of(source.snapshot.fields, "velocity_y") != nullptr;
}

bool has_first(const RasterSource& source) {
    return source.first != nullptr && source.first->bed.nx() == source.snapshot.bed.nx() &&
           source.first->bed.ny() == source.snapshot.bed.ny();
}

const char* length_unit(const Snapshot& snapshot) {
    return snapshot.scale.in_metres ? "m" : "1";
}

Grid heights_of(const Snapshot& snapshot) {
    Grid heights = snapshot.bed;
    for (double& height : heights.values()) height *= snapshot.scale.height_unit;
    return heights;
}

Raster height(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    return {"", "height of the bed", length_unit(snapshot), heights_of(snapshot), snapshot.nodata};
}

Raster water_depth(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    return {"", "depth of the water", "m", *field_of(snapshot.fields, "water_depth"),
            snapshot.nodata};
}

Raster water_surface(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    Raster raster = height(source);
    raster.long_name = "level of the water";
    const Grid& depth = *field_of(snapshot.fields, "water_depth");
    if (raster.nodata.empty()) raster.nodata = Mask(depth.nx(), depth.ny());
    for (std::size_t cell = 0; cell < depth.size(); ++cell) {
        raster.values.values()[cell] += depth.values()[cell];
        if (!(depth.values()[cell] > 0.0)) raster.nodata.values()[cell] = 1;
    }
    return raster;
}

Raster speed(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    const Grid& depth = *field_of(snapshot.fields, "water_depth");
    const Grid& east = *field_of(snapshot.fields, "velocity_x");
    const Grid& north = *field_of(snapshot.fields, "velocity_y");
    Raster raster{"", "speed of the water", "m s-1", Grid(depth.nx(), depth.ny()), snapshot.nodata};
    for (std::size_t cell = 0; cell < depth.size(); ++cell) {
        if (depth.values()[cell] > 0.0)
            raster.values.values()[cell] =
                elementary::hypot(east.values()[cell], north.values()[cell]);
    }
    return raster;
}

Raster discharge(const RasterSource& source) {
    Raster raster = speed(source);
    raster.long_name = "discharge of the water per width, depth times speed";
    raster.unit = "m2 s-1";
    const Grid& depth = *field_of(source.snapshot.fields, "water_depth");
    for (std::size_t cell = 0; cell < depth.size(); ++cell)
        raster.values.values()[cell] *= depth.values()[cell];
    return raster;
}

Raster change(const RasterSource& source) {
    Raster raster = height(source);
    raster.long_name = fmt::format("height of the bed less that of step {}", source.first->step);
    const Grid previous = heights_of(*source.first);
    for (std::size_t cell = 0; cell < previous.size(); ++cell)
        raster.values.values()[cell] -= previous.values()[cell];
    return raster;
}

GroundGradient gradient_of(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    return ground_gradient(ground_of(snapshot), snapshot.nodata, snapshot.scale.dx,
                           snapshot.scale.dy);
}

Raster slope(const RasterSource& source) {
    GroundGradient gradient = gradient_of(source);
    return {"", "angle of the ground from the horizontal (Horn 1981)", "degree",
            slope_degrees(gradient), std::move(gradient.unknown)};
}

Raster aspect(const RasterSource& source) {
    const GroundGradient gradient = gradient_of(source);
    return {"", "direction down the slope, clockwise from north (Horn 1981)", "degree",
            aspect_degrees(gradient), without_aspect(gradient)};
}

Raster shade(const RasterSource& source) {
    GroundGradient gradient = gradient_of(source);
    const HillLight& light = source.light;
    return {"",
            fmt::format("shaded relief, 1 to 255, light from {:g} degrees, {:g} above the horizon",
                        light.azimuth, light.elevation),
            "1", hillshade(gradient, light), std::move(gradient.unknown)};
}

Raster drainage(const RasterSource& source) {
    const Snapshot& snapshot = source.snapshot;
    const bool metres = snapshot.scale.in_metres;
    return {"", fmt::format("area that drains through a cell{}", metres ? "" : ", in cells"),
            metres ? "m2" : "1", drainage_area(route_flow(snapshot)), snapshot.nodata};
}

Raster wetness(const RasterSource& source) {
    GroundGradient gradient = gradient_of(source);
    return {"",
            fmt::format("topographic wetness index, ln of drained area over width (in {}) over "
                        "slope (Beven & Kirkby 1979)",
                        source.snapshot.scale.in_metres ? "m" : "cells"),
            "1", wetness_index(route_flow(source.snapshot), slope_ratio(gradient)),
            std::move(gradient.unknown)};
}

constexpr std::array<RasterQuantity, 11> quantities{
    {{"height", "height of the bed, m", always, height},
     {"water-depth", "depth of the water, m", has_depth, water_depth},
     {"water-surface", "level of the water, m; no data where it is dry", has_depth, water_surface},
     {"speed", "of the water, m/s; 0 where it is dry", has_velocity, speed},
     {"discharge", "of the water per width: depth x speed, m2/s", has_velocity, discharge},
     {"change", "height less that of the run's first record, m: sand or soil that was moved",
      has_first, change},
     {"slope", "degrees from the horizontal (Horn 1981)", always, slope},
     {"aspect", "where the ground faces, degrees clockwise from north; no data where it is level",
      always, aspect},
     {"hillshade", "1 to 255, sun from 315 degrees, 45 high, or sun.azimuth, sun.elevation", always,
      shade},
     {"drainage", "area that drains through each cell, m2 (D8, hollows filled)", always, drainage},
     {"wetness", "topographic wetness index ln(a / tan b), slopes from 0.001 up", always,
      wetness}}};

Raster raster_of(const SnapshotField& field, const Snapshot& snapshot) {
    return {field.name, field.long_name, field.unit, field.values, snapshot.nodata};
}

}  // namespace

std::span<const RasterQuantity> raster_quantities() {
    return quantities;
}

std::vector<std::string> known_rasters(const RasterSource& source) {
    std::vector<std::string> names;
    for (const RasterQuantity& quantity : quantities) {
        if (quantity.is_known(source)) names.emplace_back(quantity.name);
    }
    for (const SnapshotField& field : source.snapshot.fields) {
        if (find_named(quantities, field.name) == nullptr) names.push_back(field.name);
    }
    return names;
}

Raster make_raster(std::string_view name, const RasterSource& source) {
    const RasterQuantity* quantity = find_named(quantities, name);
    Raster raster;
    if (quantity != nullptr && quantity->is_known(source)) {
        raster = quantity->compute(source);
        raster.name = name;
    } else if (const SnapshotField* field = find_named(source.snapshot.fields, name)) {
        raster = raster_of(*field, source.snapshot);
    } else {
        const std::vector<std::string> known = known_rasters(source);
        throw InputError(fmt::format("\"{}\" {}; there {} {}", name,
                                     quantity != nullptr ? "is not in it" : "is not a field",
                                     known.size() == 1 ? "is" : "are", fmt::join(known, ", ")));
    }
    for (std::size_t cell = 0; cell < raster.nodata.size(); ++cell) {
        if (raster.nodata.values()[cell] != 0) raster.values.values()[cell] = 0.0;
    }
    if (std::ranges::all_of(raster.nodata.values(), [](auto masked) { return masked == 0; }))
        raster.nodata = {};
    return raster;
}

}  // namespace fumon
