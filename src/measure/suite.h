#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/avalanche.h"
#include "base/snapshot.h"
#include "measure/shared/measure_group.h"

namespace fumon {

class WorkerPool;

/// What a snapshot is measured as: its model's landform; a profile where a bed or terrain has a
/// single row, else a bed.
Landform measured_landform(const Snapshot& snapshot);

/// The landform of a snapshot that was read from a bare file, as far as its content tells: a pile
/// where there is a count of dropped grains, water where there is a field "water_depth", air where
/// there is a section, else a terrain, which is measured as a bed and not called sand.
Landform guessed_landform(const Snapshot& snapshot);

struct MeasuredValue {
    MeasureColumn column;
    double value;
};

/// The same value in metres where the scale has them: sites by dx, heights by the height unit,
/// cells by dx·dy.
MeasuredValue in_world_units(const MeasuredValue& measured, const WorldScale& scale);

/// What is measured besides what always is.
struct MeasureChoice {
    /// Water and terrain: the network of channels through which at least this area drains, m² (or
    /// cells of a bed that is not in metres). 0: no network.
    double channel_area = 0.0;
    /// Of a model that lives in metres, however large its cells are: lengths in metres, where
    /// others have sites and model heights.
    bool in_metres = false;
    /// What is measured alone: names of columns, and of groups of columns (MeasureSuite::names).
    /// Nothing else is computed. None: every column.
    std::vector<std::string> columns{};
};

/// What a run measures, row by row. The landform decides the columns; rows may depend on earlier
/// ones (celerity) and on all avalanches so far. Models that live in metres are measured in metres,
/// others in sites and model heights. Water and air are measured in metres and seconds,
/// the units of their models; the numbers that these models keep are columns too, under their own
/// names.
class MeasureSuite {
  public:
    /// `first` is like the snapshots that will be measured: it has the same numbers and curves.
    explicit MeasureSuite(Landform landform, const Snapshot& first = {},
                          const MeasureChoice& choice = {});
    ~MeasureSuite();
    MeasureSuite(const MeasureSuite&) = delete;
    MeasureSuite& operator=(const MeasureSuite&) = delete;

    /// In the order of a row's values; step and time are not among them.
    [[nodiscard]] const std::vector<MeasureColumn>& columns() const;

    /// What MeasureChoice::columns may name: the groups that have columns, and all columns, each
    /// in order.
    [[nodiscard]] std::vector<std::string> names() const;

    /// Records a step's avalanches, whether or not the step is measured.
    void note(std::span<const Avalanche> avalanches);

    /// One value a column; NaN where a measure has no meaning for this bed. Groups of columns are
    /// measured at once on the threads of a pool where one is given: the same values.
    [[nodiscard]] std::vector<double> row(const Snapshot& snapshot, WorkerPool* pool = nullptr);

    /// How many threads a pool may have work for.
    [[nodiscard]] int most_threads() const;

    /// Saves or restores what later rows need. Throws as StateArchive does.
    void serialise(StateArchive& archive);

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
