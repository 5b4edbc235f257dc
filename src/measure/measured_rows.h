#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "measure/measured_values.h"
#include "measure/suite.h"

namespace fumon {

class StateArchive;

/// One column of measurements, up to some step of a run.
struct MeasuredColumn {
    MeasureColumn column;
    MeasuredValues values;  ///< NaN where the measure had no meaning
};

/// Some columns of the measurements of a run up to one of its steps, in metres where the scale has
/// them. What a plot over that step's frame shows.
struct MeasuredRows {
    std::vector<MeasuredColumn> columns;

    /// nullptr where there is no column of that name.
    [[nodiscard]] const MeasuredColumn* find(std::string_view name) const;
};

/// Gathers rows, column by column.
class RowGatherer {
  public:
    /// `names` are those of the wanted columns: "step", "time" and columns of a suite; others are
    /// left out. `first` gives units.
    RowGatherer(const std::vector<std::string>& names, const std::vector<MeasureColumn>& suite,
                const Snapshot& first);

    /// Takes a row of the suite, measured of that snapshot.
    void take(const Snapshot& snapshot, const std::vector<double>& row);
    /// The rows so far. A copy stays as it is when more are taken, and shares their values.
    [[nodiscard]] const MeasuredRows& rows() const { return rows_; }
    /// Saves or restores the rows so far. Throws as StateArchive.
    void serialise(StateArchive& archive);

  private:
    static constexpr int step_column = -1;
    static constexpr int time_column = -2;

    MeasuredRows rows_;
    std::vector<int> places_;  ///< in the suite's row, or one of the above
    std::vector<double> factors_;
};

/// Every column that a run's measurements have: step, time, and the suite's in metres where the
/// scale has them.
std::vector<MeasureColumn> measured_columns(const std::vector<MeasureColumn>& suite,
                                            const Snapshot& first);

}  // namespace fumon
