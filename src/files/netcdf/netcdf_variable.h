#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// A variable that can be read as a bed, and which of its records.
struct BedVariable {
    std::string name;
    int variable = 0;
    int y = 0;  ///< its dimensions, by their NetCDF numbers
    int x = 0;
    bool has_records = false;  ///< along a third dimension
    int records = -1;          ///< that dimension, or -1
    std::size_t record = 0;    ///< from 0
    std::string note;          ///< what was chosen of several records; or empty
};

/// All variables that may be read as beds or other maps, of their last records, in the file's
/// order.
std::vector<BedVariable> map_variables(const NetcdfInput& input);

/// Which of the records of a variable over (time, y, x): one of them, from 1, or 0 for the last;
/// the last only where there is but one, if `must_name`.
struct WantedRecord {
    std::int64_t number = 0;
    bool must_name = false;
};

/// The variable `wanted`; where that is empty bed_height, else the only numeric variable over two
/// horizontal dimensions in either order, alone or with a third. Further dimensions have length 1.
/// Not among the candidates are the bounds and the two-dimensional coordinates of others. Throws
/// InputError, which lists the candidates, where the name is unknown or does not fit, for none or
/// several, and for a record that it does not have.
BedVariable choose_bed_variable(const NetcdfInput& input, const std::string& wanted,
                                const WantedRecord& record = {});

}  // namespace fumon
