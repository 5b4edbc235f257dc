#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/netcdf/netcdf_input.h"
#include "foreign/run_times.h"

namespace fumon {

/// The times along a dimension of records, by the variable of its name, else by one over it that is
/// a time by its unit ("… since …"), standard name or name. `wanted`: such a variable by name.
/// Records without any are counted, and a unit that is no time leaves them numbers, unless
/// `said` tells the unit of numbers without one. Throws InputError for a calendar that is not
/// known, NetcdfFault. The caller holds the NetcdfLock.
RawTimes netcdf_times(const NetcdfInput& input, int dimension, const std::string& wanted = {},
                      const std::string& said = {});

/// Whether a variable holds times, by its unit, its attributes or its name.
bool is_time(const NetcdfInput& input, int variable);

/// The variable that netcdf_times() reads; nothing where records are counted.
std::optional<int> time_variable(const NetcdfInput& input, int dimension);

/// The values of a variable along its only dimension; NaN where it has none.
std::vector<double> values_along(const NetcdfInput& input, int variable, int dimension);

}  // namespace fumon
