#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "base/state_archive.h"
#include "measure/shared/undefined.h"

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
    /// One value a column, of those that are wanted; the others may be anything.
    std::function<std::vector<double>(const Snapshot&, const std::vector<bool>& wanted)> values;
    std::function<void(std::span<const Avalanche>)> note{};  ///< where avalanches count
    std::function<void(StateArchive&)> serialise{};          ///< what rows draw on of earlier ones
};

/// One measure: its column, and its value in what its group found in a snapshot.
template <class Found>
struct Measure {
    std::string name;
    std::string unit;
    std::string help;
    std::function<double(const Found&)> value;
};

/// The group of measures that share what `find` computes of a snapshot, once a row. Where it finds
/// nothing (std::nullopt), all of them are undefined.
template <class Found>
MeasureGroup group_of(std::function<std::optional<Found>(const Snapshot&)> find,
                      std::vector<Measure<Found>> measures) {
    MeasureGroup group;
    for (const Measure<Found>& measure : measures)
        group.columns.push_back({measure.name, measure.unit, measure.help});
    group.values = [find = std::move(find), measures = std::move(measures)](
                       const Snapshot& snapshot, const std::vector<bool>& wanted) {
        std::vector<double> values(measures.size(), undefined);
        if (const std::optional<Found> found = find(snapshot)) {
            for (std::size_t k = 0; k < values.size(); ++k) {
                if (wanted[k]) values[k] = measures[k].value(*found);
            }
        }
        return values;
    };
    return group;
}

}  // namespace fumon
