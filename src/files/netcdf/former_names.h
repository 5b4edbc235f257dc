#pragma once

#include <string>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// What a number of a model is called in a file: its name or, in files before fumon 0.3, another.
inline std::string name_in_file(const NetcdfInput& file, const std::string& name) {
    if (file.find_variable(name)) return name;
    if (name == "pile_avalanches") return "avalanches";
    if (name == "sand_avalanche_passes") return "avalanche_passes";
    return name;
}

}  // namespace fumon
