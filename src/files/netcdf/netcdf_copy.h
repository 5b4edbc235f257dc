#pragma once

#include <cstddef>

#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_values.h"

namespace fumon {

/// Hands one record of nx × ny cells on, to record `at` of another fields file of the same
/// definition or to none, value by value and in the order in which a FieldsFile writes it, so that
/// the bytes come out the same. Throws NetcdfFault. The caller holds the NetcdfLock.
void copy_record(const NetcdfInput& from, std::size_t record, RecordValues& to,
                 const FieldsLayout& layout, int nx, int ny, std::size_t at);

}  // namespace fumon
