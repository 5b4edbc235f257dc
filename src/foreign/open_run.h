#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"

namespace fumon {

/// Whether an argument is to be opened as a run of another model and not as a folder, scene or
/// terrain: a NetCDF file, a pattern of files, an address, or another format that a message names
/// the way from.
bool is_foreign_run(const std::string& argument);

/// Opens it. Throws InputError, one line that names the format and the way in, for what is not
/// read: HDF5 without maps, VTK, Zarr, remote addresses.
ForeignRun open_foreign_run(const std::string& argument, const ForeignQuery& query = {});

/// The files that open_foreign_run() would read: the argument's, then those of the query's fields.
/// None of them is opened, nor need one be there that is named without * and ?. Throws InputError
/// for a pattern that no file has, and for a damaged query.
std::vector<std::filesystem::path> files_of_foreign_run(const std::string& argument,
                                                        const ForeignQuery& query);

/// What was recognised, a line each: files, model, grid, times, and each field with its unit,
/// dimensions, reason and range, which are those of at most 25 records.
std::string foreign_description(const ForeignRun& run);

}  // namespace fumon
