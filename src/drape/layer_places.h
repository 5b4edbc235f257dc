#pragma once

#include "drape/placed_drape.h"
#include "files/gdal/vector_file.h"
#include "scene/view/layers.h"

namespace fumon {

/// The features of a layer over a bed: brought from the layer's reference system to the bed's
/// (PROJ, through GDAL) where both have one, clipped to the bed, with points at most a cell apart.
/// The coordinates of a bed without a place are metres, or sites, from its south-western corner,
/// `cell` of them to a cell. Throws InputError where no place can be brought to the bed's system.
PlacedLayer placed_layer(const VectorLayer& layer, const BedCells& bed,
                         const std::array<double, 2>& cell);

}  // namespace fumon
