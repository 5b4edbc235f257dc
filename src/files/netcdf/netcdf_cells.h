#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "base/grid.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_variable.h"

namespace fumon {

/// Which raw values of a variable stand for no data: its _FillValue (or its type's default), every
/// missing_value, and what lies beyond valid_min, valid_max or valid_range. They are compared in
/// the variable's own type.
struct MissingValues {
    std::vector<double> values;
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool holds(double raw) const;
};

MissingValues missing_values(const NetcdfInput& input, int variable);

/// Reads a variable's raw values from `start`, so many along each dimension, in the place of the
/// NetCDF library.
using ValuesReader = std::function<void(std::span<const std::size_t> start,
                                        std::span<const std::size_t> count, double* values)>;

/// The raw values of the chosen record as (y, x) in the file's order of rows and columns, whatever
/// the order of the variable's dimensions. Integers that `_Unsigned` calls so count from 0.
/// `values`: reads them; empty: the library does.
Grid read_cells(const NetcdfInput& input, const BedVariable& bed, const ValuesReader& values = {});

/// All values of a variable over these two dimensions (and others of length 1) as (y, x).
Grid read_plane(const NetcdfInput& input, int variable, int y, int x);

}  // namespace fumon
