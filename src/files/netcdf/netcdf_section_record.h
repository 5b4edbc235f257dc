#pragma once

#include <cstddef>
#include <memory>

#include "base/snapshot.h"
#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// Reads the section of one record from a file that a FieldsFile wrote; nothing where it has none.
/// Throws NetcdfFault. The caller holds the NetcdfLock.
std::shared_ptr<const SnapshotSection> read_section(const NetcdfInput& input, std::size_t record);

}  // namespace fumon
