#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/model.h"

namespace fumon {

/// One column of measurements.csv: its name carries the unit where there is one.
struct MeasureColumn {
    std::string name;  ///< "wavelength_spectrum"
    std::string unit;  ///< "sites", "heights", "degrees" …; empty for a pure number
    std::string help;  ///< one line
};

/// What a run measures, row by row: the columns follow from the first snapshot (a bed, a profile or
/// a pile), and rows may draw on earlier ones (celerity) and on all avalanches so far.
class MeasureSuite {
  public:
    explicit MeasureSuite(const Snapshot& first);
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
