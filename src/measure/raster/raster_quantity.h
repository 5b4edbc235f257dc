#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/snapshot.h"
#include "measure/raster/ground_gradient.h"

namespace fumon {

/// One number for each cell of a snapshot, to be written as a raster.
struct Raster {
    std::string name;       ///< "slope"
    std::string long_name;  ///< what it is, in a few words
    std::string unit;       ///< "m", "degree"; "1" for pure numbers, sites and model heights
    Grid values;            ///< 0 without data
    Mask nodata;            ///< empty when every cell has a value
};

/// Of what a raster is made.
struct RasterSource {
    const Snapshot& snapshot;
    const Snapshot* first = nullptr;  ///< of the same run, its first record; null: unknown
    HillLight light{};                ///< of a hillshade
};

/// A quantity that is computed for each cell. Slope, aspect, hillshade, drainage and wetness are
/// those of the ground with the plane on which a model's bed lies.
struct RasterQuantity {
    std::string_view name;
    std::string_view help;
    bool (*is_known)(const RasterSource& source);  ///< whether the snapshot has what it needs
    Raster (*compute)(const RasterSource& source);
};

std::span<const RasterQuantity> raster_quantities();

/// The names of what a snapshot has: quantities, then its fields by their own names, which no
/// quantity has.
std::vector<std::string> known_rasters(const RasterSource& source);

/// The raster of that name. Throws InputError with the list of those that there are.
Raster make_raster(std::string_view name, const RasterSource& source);

}  // namespace fumon
