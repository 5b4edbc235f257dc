#pragma once

#include <cstdint>

#include "base/grid.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/setup/dune_ground.h"
#include "models/dunes/setup/dunes_parameters.h"

namespace fumon {

/// How high a feature stands in each cell, in parts of its height, 0 … 1: with u and v the
/// distances of the cell's middle from the feature's, along and across its axis, in parts of half
/// its length and width, and r² = u² + v²,
///
///     block   1 where |u| ≤ 1 and |v| ≤ 1, else 0
///     cone    max(1 − r, 0)
///     hill    cos²(π r / 2) where r < 1, else 0
///
/// In a periodic bed distances go the shorter way round.
Grid feature_shape(const DuneFeature& feature, const DuneGround& ground);

/// Cuts ravines into such a shape: what is left of it is 1 − feature.ravines · depth, with depths
/// of Ravines whose longest are .3 of the shorter side apart. `rock` numbers the features of a bed.
void cut_ravines(Grid& shape, const DuneFeature& feature, const DuneGround& ground,
                 std::uint64_t seed, std::uint32_t rock);

/// Sets rock and sand on a bed, one after the other: rock, with its ravines, raises the floor, and
/// the surface where the sand there was no thicker; sand and sources raise the surface.
void set_features(const std::vector<DuneFeature>& features, const DuneGround& ground,
                  std::uint64_t seed, DuneBed& bed);

/// The thickness of sand that sources keep, 0 where there are none; empty where no feature is one.
FixedPointGrid sources_of(const std::vector<DuneFeature>& features, const DuneGround& ground);

}  // namespace fumon
