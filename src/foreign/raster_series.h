#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"

namespace fumon {

/// A series of rasters as a run: a file a record, in the order of the numbers or dates in their
/// names. They are depths or levels of water where a model calls its files so (variable_names.h),
/// else beds. Throws InputError.
ForeignRun read_raster_series(const std::string& name,
                              const std::vector<std::filesystem::path>& files,
                              const ForeignQuery& query);

}  // namespace fumon
