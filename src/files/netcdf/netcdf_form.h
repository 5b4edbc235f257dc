#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

/// What the sections of every record have in common.
struct SectionForm {
    double dx = 0.0;
    double dz = 0.0;
    int nz = 0;
    std::vector<std::string> fields;
    std::vector<std::string> curves;
    std::size_t paths = 0;

    bool operator==(const SectionForm&) const = default;
};

/// What every record of a file has in common.
struct RecordForm {
    int nx = 0;
    int ny = 0;
    WorldScale scale;
    std::vector<std::string> fields;
    std::vector<std::string> numbers;
    std::optional<SectionForm> section;
};

RecordForm record_form(const Snapshot& snapshot);

/// Throws Error "cannot write FILE: …" for a snapshot whose fields have another size than its bed,
/// and for a section below 2 x 2 nodes or over a bed of several rows.
void check_whole(const std::filesystem::path& file, const Snapshot& snapshot);

/// Throws Error for a snapshot that is not whole or of another form than the file's.
void check_form(const std::filesystem::path& file, const RecordForm& form,
                const Snapshot& snapshot);

/// A snapshot without the values of its fields: all that a file's definition needs.
Snapshot outline_of(const Snapshot& snapshot);

}  // namespace fumon
