#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "film/beds/stored_beds.h"
#include "view/subject/subject.h"

namespace fumon {

/// A finished run by the beds that it stored. Throws as StoredBeds.
std::unique_ptr<ViewSubject> stored_subject(const std::filesystem::path& folder, int threads,
                                            const std::vector<std::string>& settings);

/// The same of stored beds, with a table of measurements; there may be none.
std::unique_ptr<ViewSubject> stored_subject(StoredBeds beds, std::filesystem::path measurements);

/// The columns of a table of measurements, of its whole lines alone: another program may be
/// writing it. None where there is no such file.
std::vector<ViewColumn> measurements_of(const std::filesystem::path& file);

/// The results of another model (StoredBeds::of_files); nullptr where `argument` is neither a
/// pattern nor a NetCDF file of several records: a grid of heights then, or a scene. Throws
/// InputError for a pattern that cannot be read.
std::unique_ptr<ViewSubject> foreign_subject(const std::string& argument, int threads,
                                             const std::vector<std::string>& settings);

}  // namespace fumon
