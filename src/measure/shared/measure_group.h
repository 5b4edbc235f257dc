#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "base/state_carrier.h"

namespace fumon {

/// One column of measurements.csv.
struct MeasureColumn {
    std::string name;  ///< "wavelength_spectrum"
    std::string unit;  ///< "sites", "heights", "degrees" …; empty for a pure number
    std::string help;  ///< one line: how it is defined
};

/// Measures that are taken together: their columns, and the values in the same order.
struct MeasureGroup {
    std::vector<MeasureColumn> columns;
    std::function<std::vector<double>(const Snapshot&)> values;
    std::function<void(std::span<const Avalanche>)> note{};  ///< where avalanches count
    std::function<void(StateCarrier&)> carry{};              ///< what rows draw on of earlier ones
};

}  // namespace fumon
