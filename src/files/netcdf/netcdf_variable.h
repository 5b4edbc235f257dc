#pragma once

#include <cstddef>
#include <string>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// A variable that can be read as a bed, and which of its records.
struct BedVariable {
    std::string name;
    int variable = 0;
    int y = 0;  ///< its dimensions, by their NetCDF numbers
    int x = 0;
    bool has_records = false;  ///< a dimension before y and x
    std::size_t record = 0;    ///< the last
    std::string note;          ///< what was chosen of several records; or empty
};

/// The variable `wanted`; where that is empty bed_height, else the only numeric variable over two
/// horizontal dimensions, alone or behind a third. Not among the candidates are the bounds and the
/// two-dimensional coordinates of others. Throws InputError, which lists the candidates, where the
/// name is unknown or does not fit, and for none or several.
BedVariable choose_bed_variable(const NetcdfInput& input, const std::string& wanted);

}  // namespace fumon
