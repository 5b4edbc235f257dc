#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "files/netcdf/netcdf_values.h"

namespace fumon {

/// The variables of a section in a fields file, by their NetCDF numbers. Lengths are in metres.
struct SectionLayout {
    int x = 0;                ///< section_x(section_x): the columns, i·dx; the file's x is centres
    int z = 0;                ///< z(z): the nodes, k·dz, positive up
    std::vector<int> fields;  ///< one each of SnapshotSection::fields, over (date, z, section_x)
    std::vector<int> curves;  ///< one each of SnapshotSection::curves, over (date, section_x)
    /// Where the section has paths. `path_point` is unlimited: a shorter path ends in _FillValue.
    struct Paths {
        int launch_angle = 0;  ///< launch_angle(date, path), degrees to the local bed
        int x = 0;             ///< path_x(date, path, path_point)
        int z = 0;             ///< path_z(date, path, path_point)
    };
    std::optional<Paths> paths{};
};

/// A curve or field has its own name in the file, but the section's own "bed_height" is
/// "section_bed_height", beside the file's bed_height(date, y, x), and a point becomes an
/// underscore ("flight_length_12_5"): CF knows no points. The curve's attribute
/// own_name_attribute keeps its name then.
inline constexpr const char* own_name_attribute = "fumon_name";
std::string section_name_in_file(const std::string& name);
/// The other way round.
std::string section_name_in_snapshot(const std::string& name);

/// All names of variables that define_section gives.
std::vector<std::string> section_variable_names(const SnapshotSection& section);

/// Defines a section's dimensions and variables, all float64 with NaN as _FillValue, so that a
/// curve's NaN is missing; `section` has fields. Throws NetcdfFault. The caller holds the
/// NetcdfLock.
SectionLayout define_section(int file, int time, const SnapshotSection& section);

/// Writes section_x and z, once the definitions have ended.
void put_section_coordinates(int file, const SectionLayout& layout, const SnapshotSection& section);

/// Writes one record: `section` has the fields, curves and number of paths of the one defined.
void write_section(RecordValues& file, const SectionLayout& layout, std::size_t record,
                   const SnapshotSection& section);

/// Bytes of one record's values at most, uncompressed, in whole chunks.
std::int64_t section_record_bytes(const SnapshotSection& section);

}  // namespace fumon
