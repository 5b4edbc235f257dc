#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/sha256.h"
#include "files/netcdf/netcdf_fields.h"

namespace fumon {

/// A fields file while it is written, as NAME.part: from its definition to its closing.
class FieldsPiece {
  public:
    /// `first`: a snapshot like every record's, or its outline (netcdf_form.h). `hash` goes on with
    /// the values of the records (RecordValues), and outlives this. Throws Error where the file
    /// cannot be made.
    FieldsPiece(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text,
                Sha256Stream& hash);
    /// Deletes the file unless it was closed.
    ~FieldsPiece();
    FieldsPiece(const FieldsPiece&) = delete;
    FieldsPiece& operator=(const FieldsPiece&) = delete;

    /// As FieldsFile::add.
    void add(const Snapshot& snapshot);
    /// Appends the first `count` records of another fields file of the same definition. Throws
    /// Error, InputError where that file cannot be read.
    void copy(const std::filesystem::path& from, std::int64_t count);
    [[nodiscard]] std::int64_t records() const;

    /// Closes the file, puts it on disk and gives it a name. After a failed record it does so with
    /// those before, if the file still opens. Throws Error.
    void close_as(const std::filesystem::path& name);

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
