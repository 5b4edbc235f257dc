#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/sha256.h"
#include "base/snapshot.h"

namespace fumon {

/// What a fields file says of its run.
struct FieldsText {
    std::string title;
    std::string scene;      ///< the resolved scene as TOML
    std::int64_t seed = 1;  ///< of the scene
};

/// The first records of a fields file that grows.
struct FieldsBeginning {
    std::int64_t records = -1;  ///< −1: there was no file
    Sha256 hash{};              ///< of their values (RecordValues)
};

/// A NetCDF-4 file of a run's fields over (time, y, x), and of its section's over (time, z,
/// section_x), record by record, by the CF conventions 1.9 (1.8 has no 64-bit integers); the names,
/// units and attributes are those of netcdf_layout.h and netcdf_section.h.
///
/// The file is made as NAME.part and gets its name by commit(). After every add() the file on disk
/// is whole, so that a run that is killed between two records leaves a NAME.part that opens, with
/// all records so far; a kill within the instant in which a record's index is written (tens of
/// microseconds) may leave it unreadable. While it is being written HDF5's lock keeps other
/// programs from opening it (unless HDF5_USE_FILE_LOCKING=FALSE). Disk space is set aside before a
/// record is begun, so a full disk refuses the record and leaves the file as it was, still fit for
/// commit(). An uncommitted file is deleted: a run that is interrupted or fails commits what it
/// has.
///
/// Same records and text give the same bytes, with the same versions of the NetCDF and HDF5
/// libraries. Memory does not grow with the records. Any threads may write different files at the
/// same time (they take turns, see NetcdfLock); one file belongs to one thread at a time.
class FieldsFile {
  public:
    /// `first` gives the size, the fields, the numbers, the section and the units of every record;
    /// it is not itself recorded. Throws Error where the file cannot be made, for a field, number
    /// or curve whose name is no NetCDF name or is there twice, and for a section below 2 x 2 nodes
    /// or over a bed of several rows.
    FieldsFile(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text);
    /// Goes on with the file that a run of the same first snapshot and text left, whether under its
    /// temporary name or its own: makes it anew with copies of its first records, so that it gets
    /// the bytes of a file that was written in one go. The former one stays as NAME.former until
    /// then, and an uncommitted file is kept. Throws InputError where the former one is not there,
    /// cannot be read or has not these records.
    FieldsFile(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text,
               const FieldsBeginning& former);
    ~FieldsFile();
    FieldsFile(const FieldsFile&) = delete;
    FieldsFile& operator=(const FieldsFile&) = delete;

    /// Appends one record and puts it on disk. Throws Error, and appends nothing, for a snapshot
    /// whose size, scale, fields, numbers or section (its spacing, fields, curves and number of
    /// paths; not their lengths) differ from the file's, and when the disk is full.
    void add(const Snapshot& snapshot);

    [[nodiscard]] std::int64_t records() const;

    /// Puts all records on disk (fsync). Throws Error on failure.
    [[nodiscard]] FieldsBeginning sync();

    /// Closes the file and gives it its name. Throws Error on failure.
    void commit();

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

/// Under which name a run that was stopped left its fields file: NAME.former, NAME.part or NAME.
std::filesystem::path left_fields(const std::filesystem::path& file);

/// Why the file that a run of this first snapshot left does not begin with these records: "is not
/// there", "has 2 records of 7" …; empty where it does. Reads them all.
std::string difference(const std::filesystem::path& file, const Snapshot& first,
                       const FieldsBeginning& beginning);

}  // namespace fumon
