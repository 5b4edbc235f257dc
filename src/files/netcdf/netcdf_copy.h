#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_values.h"

namespace fumon {

/// The variables of a file that records are taken from, by their NetCDF numbers. Files of earlier
/// versions have them in another order, and no date.
struct SourceVariables {
    int bed = 0;
    std::vector<int> fields;
    std::vector<int> numbers;
    int step = 0;
    int time = 0;
};

/// Those of these names. Throws NetcdfFault where one is missing. The caller holds the NetcdfLock.
SourceVariables source_variables(const NetcdfInput& from, const std::vector<std::string>& fields,
                                 const std::vector<std::string>& numbers);

/// Hands one record of nx × ny cells on, to record `at` of another fields file of the same
/// fields or to none, value by value and in the order in which a FieldsFile writes it, so that
/// the bytes come out the same. Throws NetcdfFault. The caller holds the NetcdfLock.
void copy_record(const NetcdfInput& from, const SourceVariables& source, std::size_t record,
                 RecordValues& to, const FieldsLayout& layout, int nx, int ny, std::size_t at);

}  // namespace fumon
