#pragma once

#include <functional>
#include <span>
#include <vector>

#include "measure/suite.h"
#include "support/state_carrier.h"

namespace fumon {

/// Measures that are taken together: their columns, and the values in the same order.
struct MeasureGroup {
    std::vector<MeasureColumn> columns;
    std::function<std::vector<double>(const Snapshot&)> values;
    std::function<void(std::span<const Avalanche>)> note{};  ///< where avalanches count
    std::function<void(StateCarrier&)> carry{};              ///< what rows draw on of earlier ones
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
/// Channels, their course, and the bed of a single one.
MeasureGroup channel_group();
/// How uneven water and bed are.
MeasureGroup water_relief_group();
/// Fluxes, speeds and Froude numbers.
MeasureGroup water_flow_group();
/// Speed, divergence, eddy and pressure of the air in a section.
MeasureGroup air_group();
/// The bed's shear stress beside the bed.
MeasureGroup stress_group();
/// Flight lengths, a column for each curve "flight_length_…" that a snapshot has.
MeasureGroup flight_group(const Snapshot& first);
/// The numbers that a model keeps itself, as the first snapshot has them, but for those named.
MeasureGroup number_group(const Snapshot& first, std::span<const MeasureColumn> taken);

}  // namespace fumon
