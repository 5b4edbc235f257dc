#pragma once

#include <string>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// The variable of a model's number. ParaView begins at the variable whose name comes first, which
/// is to be the bed
/// ("bed_height"), so that none comes before.
inline std::string variable_of_number(const std::string& name) {
    if (name == "avalanches") return "pile_avalanches";
    if (name == "avalanche_passes") return "sand_avalanche_passes";
    return name;
}

/// The variable of a model's number in a file: files before fumon 0.3 call it by its name.
inline std::string name_in_file(const NetcdfInput& file, const std::string& name) {
    std::string variable = variable_of_number(name);
    return file.find_variable(variable) ? variable : name;
}

}  // namespace fumon
