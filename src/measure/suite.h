#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "measure/shared/measure_group.h"

namespace fumon {

/// What a snapshot is measured as: its model's landform; a profile where a bed or terrain has a
/// single row, else a bed.
Landform measured_landform(const Snapshot& snapshot);

/// The landform of a snapshot that was read from a bare file, as far as its content tells: a pile
/// where there is a count of dropped grains, water where there is a field "water_depth", air where
/// there is a section, else a bed.
Landform guessed_landform(const Snapshot& snapshot);

struct MeasuredValue {
    MeasureColumn column;
    double value;
};

/// The same value in metres where the scale has them: sites by dx, heights by the height unit,
/// cells by dx·dy.
MeasuredValue in_world_units(const MeasuredValue& measured, const WorldScale& scale);

/// What a run measures, row by row: the columns follow from the landform, and rows may draw on
/// earlier ones (celerity) and on all avalanches so far. Water and air live in metres and seconds
/// and are measured in them; the numbers that their models keep are columns too, by their names.
class MeasureSuite {
  public:
    /// `first` is a snapshot such as will be measured: which numbers and curves it has.
    explicit MeasureSuite(Landform landform, const Snapshot& first = {});
    ~MeasureSuite();
    MeasureSuite(const MeasureSuite&) = delete;
    MeasureSuite& operator=(const MeasureSuite&) = delete;

    /// In the order of a row's values; step and time are not among them.
    [[nodiscard]] const std::vector<MeasureColumn>& columns() const;

    /// Takes note of a step's avalanches, whether or not the step is measured.
    void note(std::span<const Avalanche> avalanches);

    /// One value a column; NaN where a measure has no meaning for this bed.
    [[nodiscard]] std::vector<double> row(const Snapshot& snapshot);

    /// Carries what later rows draw on. Throws as StateCarrier.
    void carry(StateCarrier& carrier);

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
