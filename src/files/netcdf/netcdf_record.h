#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

/// What the last record of a fields file holds beside its bed.
struct FieldsRecord {
    bool periodic = false;
    std::vector<SnapshotField> fields;               ///< 0 in cells without data
    std::vector<SnapshotNumber> numbers;             ///< those that the model kept
    std::shared_ptr<const SnapshotSection> section;  ///< where the file has one
};

/// Reads it from a file that a FieldsFile wrote, which its attribute `source` and its bed_height
/// tell; nothing from any other file. The units are those in the file ("1" for sites and the like).
/// Throws InputError "FILE: what; remedy" for a damaged one, and for one without a record.
std::optional<FieldsRecord> read_fields_record(const std::filesystem::path& file);

/// Whether a file is one that a FieldsFile wrote. Throws as above.
bool is_fields_file(const std::filesystem::path& file);

/// When a record of a fields file was taken.
struct FieldsMoment {
    std::int64_t step = 0;
    double time = 0.0;
};

/// The moments of all records of such a file, in their order. Throws InputError where it is damaged
/// or no such file.
std::vector<FieldsMoment> read_fields_moments(const std::filesystem::path& file);

/// The resolved scene, as TOML, of the run that wrote such a file. Throws InputError where it holds
/// none.
std::string read_fields_scene(const std::filesystem::path& file);
/// The version of fumon that wrote the file; empty where it does not say.
std::string read_fields_version(const std::filesystem::path& file);

/// The snapshot of a step from such a file. What changes from step to step is the record's: bed,
/// fields, numbers, section, step and time; all else (size, units, names, scale) is that of
/// `outline`, whose own values do not matter. Where that has a mask, the cells that have no bed in
/// the file lie outside, and their heights are 0. Throws InputError where the file is damaged or of
/// another run, or has no record of that step.
Snapshot read_fields_snapshot(const std::filesystem::path& file, std::int64_t step,
                              Snapshot outline);

}  // namespace fumon
