#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"
#include "foreign/quantity.h"

namespace fumon {

/// A field of another model's run, as it was recognised.
struct ForeignField {
    Quantity quantity = Quantity::bed;
    std::string name;         ///< the variable, or the pattern of its files
    std::string unit;         ///< in the file; empty where it names none
    std::string dimensions;   ///< "time, n, m"; empty for files of their own
    std::string reason;       ///< how it was known: "CF standard name altitude"
    bool changes = false;     ///< with time
    bool by_compass = false;  ///< a velocity toward the east or north, not along a side of the grid
    /// The values of a record in fumon's unit, row 0 southernmost; NaN where there are none. Throws
    /// InputError for a damaged file.
    std::function<Grid(std::size_t record)> read;
};

/// A further map of another model's run, shown by its own name: shear stress, sediment …
struct ForeignScalar {
    std::string name;       ///< the variable
    std::string long_name;  ///< as the file has it; else its name in words
    std::string unit;       ///< in the file; empty where it names none
    bool changes = false;   ///< with time
    /// The values of a record as ForeignField has them, in the file's unit.
    std::function<Grid(std::size_t record)> read;
};

/// When the records of a run were taken.
struct ForeignTimes {
    std::vector<double> times;        ///< in `unit`, rising
    std::vector<std::int64_t> steps;  ///< 0, 1 … where the file has no steps of its own
    std::string unit = "steps";       ///< as Snapshot::time_unit
    /// The date of a time; empty where the file's times have none.
    std::function<std::string(double time)> date{};
    std::string note{};  ///< "no time is known: records are counted"
};

/// A run of another model as its files hold it: what was recognised, and how to read a record.
struct ForeignRun {
    std::string name;   ///< for messages: as it was given
    std::string model;  ///< "XBeach"; empty where it is not known
    std::string title;  ///< as the file has it; else its name
    std::vector<std::filesystem::path> files;
    int nx = 0;
    int ny = 0;
    WorldScale scale;
    double turn = 0.0;                 ///< radians, of the columns' direction against the east
    bool swapped = false;              ///< the file's rows are the columns
    bool columns_fall = false;         ///< the columns run against those of the file, or its rows
    bool rows_fall = false;            ///< likewise the rows
    std::vector<ForeignField> fields;  ///< at most one of a quantity, the bed among them
    std::vector<ForeignScalar> scalars{};  ///< those that were asked for
    std::vector<std::string> others;       ///< further maps: "hmax (timemax, n, m)"
    ForeignTimes times;
    std::vector<double> numbers{};  ///< of a series of rasters: those in their names
    double dry = 0.0;               ///< metres, the least depth of water
    std::vector<std::string> notes;

    [[nodiscard]] const ForeignField* find(Quantity quantity) const;
    [[nodiscard]] bool has_water() const;
};

/// What a user says of a run of another model beside its file.
struct ForeignQuery {
    std::vector<std::string> fields{};   ///< "depth=h", "bed=dem.tif", "bed=grid.nc:zb"
    std::string time_pattern{};          ///< of dates in names of files: "%Y-%m-%d"
    std::string time_unit{};             ///< of numbers in names of files: "min"
    double cell_size = 0.0;              ///< metres, of rasters that do not say theirs; 0: unknown
    std::vector<std::string> scalars{};  ///< variables that snapshots have as fields of these names
};

/// The snapshot of a record. Cells without a bed are its no-data cells; water shallower than the
/// run's `dry` is none. Velocities are those of the file, or its discharges over the depth, or 0;
/// on a turned grid those by compass are turned to its sides, and others, which
/// are along the file's columns and rows, change places and signs with these. Concentrations and
/// the run's scalars are fields too.
/// Without a bed of its own it is the level minus the depth. Throws InputError for a damaged file
/// and for a record without any bed.
Snapshot foreign_snapshot(const ForeignRun& run, std::size_t record);

/// The bed of a record alone.
Snapshot foreign_bed(const ForeignRun& run, std::size_t record);

}  // namespace fumon
