#pragma once

#include <optional>
#include <vector>

#include "files/netcdf/netcdf_fields.h"
#include "files/netcdf/netcdf_section.h"

namespace fumon {

/// The variables of a fields file, by their NetCDF numbers.
struct FieldsLayout {
    int date = 0;              ///< date(date), float64
    int time = 0;              ///< time(date), float64
    int step = 0;              ///< step(date), float64
    int bed = 0;               ///< bed_height(date, y, x), float64
    std::vector<int> fields;   ///< one each of Snapshot::fields, float64 over (date, y, x)
    std::vector<int> numbers;  ///< one each of Snapshot::numbers, float64 over (date)
    std::optional<SectionLayout> section;  ///< where snapshots have one
    int rows = 1;              ///< rows of a chunk: what is compressed and written at once
    double date_factor = 1.0;  ///< from the snapshot's time to the file's date
    double bed_factor = 1.0;   ///< from the snapshot's bed to the file's
};

/// Defines a fields file that has just been made, and writes its coordinates x and y.
///
/// x and y are the centres of the cells, (i + 0.5)·dx and (j + 0.5)·dy, both ascending: in "m" with
/// standard names where the scale is in metres, else in sites with unit "1"; counted from the
/// south-west corner, or, where the terrain lies on a map in metres or degrees, in that map's
/// coordinates, whose reference system is the grid mapping `crs` (netcdf_place.h). A row or column
/// alone that lies on no map has no coordinate. bed_height is in
/// metres ("m", standard name surface_altitude) or else in model heights
/// ("1"): heights × height_unit in both cases, as the beds that a run writes and reads. Cells
/// without data are NaN, the _FillValue, in every field.
///
/// A record is a `date`, the coordinate of the dimension of that name: seconds, minutes, hours or
/// days since 2000-01-01, on which no run began, since CF knows no time without a reference and VTK
/// no other time. `time` is the model's: the step number with unit "1", or a time since the run's
/// start in "s", "yr" and the like. `step` is a float64, exact to 2^53, as CF 1.8 and VTK know no
/// 64-bit integers. Units that udunits does not know ("sites", "grains") become "1" and stand in
/// brackets in the long name. A section's variables are those of SectionLayout.
///
/// Every variable but the scalar `crs` is in chunks with checksums.
///
/// Global attributes: Conventions, title, source, history (none of them holds the clock), scene,
/// seed, cell_size_x, cell_size_y, cell_size_unit, height_unit, periodic ("yes" or "no").
/// Throws NetcdfFault, and Error for names that do not do: a letter comes first, then letters,
/// digits and underscores, as CF recommends, and points ("flight_length_12.5"). The caller holds
/// the NetcdfLock.
FieldsLayout define_fields(int file, const Snapshot& first, const FieldsText& text);

/// Bytes that the header and the coordinates take at most, generously.
std::int64_t header_room(const Snapshot& first, const FieldsText& text);

/// Bytes by which one record lets the file grow at most: its values uncompressed, and the index.
std::int64_t record_room(const Snapshot& first);

}  // namespace fumon
