#pragma once

#include <string>

#include "base/grid.h"

namespace fumon {

/// What horizontal lengths of a figure are shown in.
struct LengthUnit {
    double length = 1.0;           ///< of one unit, in the bed's lengths (metres or sites)
    std::string symbol = "sites";  ///< "mm", "m", "km" or "sites"
};

/// The unit that shows a length (metres, or sites without metres) by a convenient number: mm below
/// 1 m, km from 10 km on, sites where the bed has no metres.
LengthUnit length_unit(bool in_metres, double length);

/// The unit that shows heights or depths of up to `largest` metres: mm below half a metre, else m;
/// model heights where the bed has no metres. Its length is in metres, or model heights.
LengthUnit height_unit(bool in_metres, double largest);

/// The extents of a bed of cells, in metres or sites.
struct BedExtent {
    double width = 0.0;   ///< along x
    double height = 0.0;  ///< along y
};

inline BedExtent bed_extent(const Grid& bed, const WorldScale& scale) {
    return {bed.nx() * scale.dx, bed.ny() * scale.dy};
}

}  // namespace fumon
