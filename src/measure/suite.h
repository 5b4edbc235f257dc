#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/model.h"

namespace fumon {

/// What kind of bed is measured: it decides which measures there are.
enum class Landform { bed, profile, pile };

/// A pile where the model keeps count of dropped grains, a profile where there is a single row,
/// else a bed.
Landform landform_of(const Snapshot& snapshot);

/// One column of measurements.csv.
struct MeasureColumn {
    std::string name;  ///< "wavelength_spectrum"
    std::string unit;  ///< "sites", "heights", "degrees" …; empty for a pure number
    std::string help;  ///< one line: how it is defined
};

struct MeasuredValue {
    MeasureColumn column;
    double value;
};

/// The same value in metres where the scale has them: sites by dx, heights by the height unit,
/// cells by dx·dy.
MeasuredValue in_world_units(const MeasuredValue& measured, const WorldScale& scale);

/// What a run measures, row by row: the columns follow from the landform, and rows may draw on
/// earlier ones (celerity) and on all avalanches so far.
class MeasureSuite {
  public:
    explicit MeasureSuite(Landform landform);
    ~MeasureSuite();
    MeasureSuite(const MeasureSuite&) = delete;
    MeasureSuite& operator=(const MeasureSuite&) = delete;

    /// In the order of a row's values; step and time are not among them.
    [[nodiscard]] const std::vector<MeasureColumn>& columns() const;

    /// Takes note of a step's avalanches, whether or not the step is measured.
    void note(std::span<const Avalanche> avalanches);

    /// One value a column; NaN where a measure has no meaning for this bed.
    [[nodiscard]] std::vector<double> row(const Snapshot& snapshot);

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
