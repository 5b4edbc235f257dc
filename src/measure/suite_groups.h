#pragma once

#include <functional>
#include <span>
#include <vector>

#include "measure/suite.h"

namespace fumon {

/// Measures that are taken together: their columns, and the values in the same order.
struct MeasureGroup {
    std::vector<MeasureColumn> columns;
    std::function<std::vector<double>(const Snapshot&)> values;
    std::function<void(std::span<const Avalanche>)> note{};  ///< where avalanches count
};

/// Mean, spread and extremes of the heights, and their sum.
MeasureGroup statistics_group();
/// The three wavelengths and the two heights of waves.
MeasureGroup wave_group();
/// Celerity since the row before.
MeasureGroup celerity_group();
MeasureGroup slope_group();
/// Orientation and defects of crests.
MeasureGroup crest_group();
/// Separate dunes.
MeasureGroup dune_group();
/// Grains, and the cone that the pile is.
MeasureGroup pile_group();
/// The last avalanche, and the sizes of all so far.
MeasureGroup avalanche_group();

}  // namespace fumon
