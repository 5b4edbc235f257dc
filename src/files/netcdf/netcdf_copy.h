#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_values.h"

namespace fumon {

/// Copies one record of nx × ny cells between two fields files of the same definitions, value by
/// value and in the order in which a FieldsFile writes it, so that the bytes come out the same.
/// Throws NetcdfFault. The caller holds the NetcdfLock.
void copy_record(const NetcdfInput& from, RecordValues& to, const FieldsLayout& layout, int nx,
                 int ny, std::size_t record);

/// Copies the first records of a former file, calling `before` each. Says why they are not those
/// that were written, "has 2 records of 7" …; empty where they are. Throws what `before` throws.
/// The caller holds the NetcdfLock.
std::string copy_records(const std::filesystem::path& former, const FieldsBeginning& beginning,
                         RecordValues& to, const FieldsLayout& layout, int nx, int ny,
                         const std::function<void()>& before);

}  // namespace fumon
