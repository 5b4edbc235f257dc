#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/sha256.h"
#include "base/snapshot.h"

namespace fumon {

/// What a fields file says of its run.
struct FieldsText {
    std::string title;
    std::string scene;      ///< the resolved scene as TOML; empty: it is no run's
    std::int64_t seed = 1;  ///< of the scene
};

/// The first records of a fields file that grows.
struct FieldsBeginning {
    std::int64_t records = -1;  ///< −1: there was no file
    Sha256 hash{};              ///< of their values (RecordValues)
};

/// A NetCDF-4 file of a run's fields over (date, y, x), and of its section's over (date, z,
/// section_x), record by record, by the CF conventions 1.8; the names,
/// units and attributes are those of netcdf_layout.h and netcdf_section.h.
///
/// The file is made as NAME.part and gets its name by commit(). HDF5 changes a file in places that
/// it has written before, so that no crash may befall one that still matters: sync() closes what
/// there is as a piece, NAME.000001, NAME.000002 …, which is never written to again, and the next
/// record begins another; commit() joins them. While it is being written HDF5's lock keeps other
/// programs from opening NAME.part (unless HDF5_USE_FILE_LOCKING=FALSE), which after every add()
/// holds its records so far. Disk space is set aside before a record is begun, so a full disk
/// refuses the record and leaves the file as it was, still fit for commit(). NAME.part is deleted
/// if it is not committed, pieces stay: a run that is interrupted or fails commits what it has.
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
    /// Goes on with the first records that a run of the same first snapshot and text left in its
    /// pieces or, joined, under its name; the file gets the bytes of one that was written in one
    /// go. Throws InputError, naming the piece, where one is not there, cannot be read or has not
    /// these records. `text_is_new`: the records were written with another text.
    FieldsFile(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text,
               const FieldsBeginning& previous, bool text_is_new = false);
    ~FieldsFile();
    FieldsFile(const FieldsFile&) = delete;
    FieldsFile& operator=(const FieldsFile&) = delete;

    /// Appends one record and puts it on disk. Throws Error, and appends nothing, for a snapshot
    /// whose size, scale, fields, numbers or section (its spacing, fields, curves and number of
    /// paths; not their lengths) differ from the file's, and when the disk is full.
    void add(const Snapshot& snapshot);

    [[nodiscard]] std::int64_t records() const;

    /// Closes all records so far as a piece and puts it on disk (fsync). Throws Error on failure.
    [[nodiscard]] FieldsBeginning sync();

    /// Joins the pieces, closes the file, puts it on disk and gives it its name. Throws Error on
    /// failure; the pieces stay then.
    void commit();

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

/// Where what a stopped run left of a fields file is not what it wrote.
struct FieldsDifference {
    std::filesystem::path file;  ///< NAME, or one of its pieces
    std::string what;  ///< "does not exist", "has 2 records of 7" …; empty where nothing is
};

/// Compares what a run of this first snapshot left with the records that it had. Reads them all.
FieldsDifference difference(const std::filesystem::path& file, const Snapshot& first,
                            const FieldsBeginning& beginning);

/// The number of the piece of a fields file that a name is ("fields.nc.000002" of "fields.nc"); 0
/// of any other name.
std::int64_t number_of_fields_piece(std::string_view name, std::string_view file);

/// Deletes all pieces of a fields file.
void remove_fields_pieces(const std::filesystem::path& file);

}  // namespace fumon
