#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"
#include "foreign/quantity.h"

namespace fumon {

/// What --field says: "depth=h", "bed=dem.tif", "bed=grid.nc:zb", "depth=waterdepth*.txt".
struct FieldRequest {
    Quantity quantity = Quantity::bed;
    std::string source;  ///< a variable, a file, a file and its variable, or a pattern of files
};

/// Throws InputError for another text and an unknown quantity.
FieldRequest field_request(const std::string& text);

/// Whether a source is a file or a pattern of files, not a variable.
bool is_file_request(const std::string& source);

/// The files of such a source, none of which is opened; none where it is a variable. Throws
/// InputError for a pattern that no file has.
std::vector<std::filesystem::path> files_of_source(const std::string& source);

/// Adds a field from files of its own to a run: of one file, which does not change, or of a series
/// that has a file for each record of the run, paired by the numbers in their names where the run
/// is a series, else in order. Throws InputError.
void add_field_of_file(ForeignRun& run, Quantity quantity, const std::string& source,
                       const ForeignQuery& query);

}  // namespace fumon
