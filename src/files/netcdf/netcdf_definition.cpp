#include "files/netcdf/netcdf_definition.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <limits>

#include "files/netcdf/netcdf_calls.h"
#include "files/udunits_unit.h"

namespace fumon {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20;

}  // namespace

void put_text(int file, int variable, const char* name, std::string_view text) {
    check_netcdf(nc_put_att_text(file, variable, name, text.size(), text.data()));
}

void put_number(int file, int variable, const char* name, double value) {
    check_netcdf(nc_put_att_double(file, variable, name, NC_DOUBLE, 1, &value));
}

std::string unit_in_file(const std::string& unit) {
    const std::string by_symbols = udunits_unit(unit, true);
    const bool reads_as_it_is = by_symbols != "1" && !unit.starts_with("per ") && unit != "deg";
    return reads_as_it_is ? unit : by_symbols;
}

void describe(int file, int variable, const std::string& long_name, const std::string& unit) {
    const std::string in_file = unit_in_file(unit);
    const bool says_less = in_file == "1" && unit != "1" && !unit.empty();
    put_text(file, variable, "long_name",
             says_less ? fmt::format("{} ({})", long_name, unit) : long_name);
    put_text(file, variable, "units", in_file);
}

int rows_of_chunk(const Grid& field) {
    const std::size_t row_bytes = static_cast<std::size_t>(field.nx()) * sizeof(double);
    const int most = static_cast<int>(
        std::clamp(chunk_bytes / row_bytes, std::size_t{1}, static_cast<std::size_t>(field.ny())));
    const int blocks = (field.ny() + most - 1) / most;
    return (field.ny() + blocks - 1) / blocks;
}

void fill_with_nan(int file, int variable, std::size_t chunk_values) {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    check_netcdf(nc_def_var_fill(file, variable, NC_FILL, &not_a_number));
    constexpr std::size_t slots = 11;
    constexpr float preemption = 1.0F;
    check_netcdf(
        nc_set_var_chunk_cache(file, variable, chunk_values * sizeof(double), slots, preemption));
}

void compress(int file, int variable) {
    constexpr int shuffle = 1;
    constexpr int deflate = 1;
    constexpr int level = 1;  // most of the gain at a third of level 6's time
    check_netcdf(nc_def_var_deflate(file, variable, shuffle, deflate, level));
}

void protect(int file, int variable) {
    check_netcdf(nc_def_var_fletcher32(file, variable, NC_FLETCHER32));
}

int define_coordinate(int file, const char* name, int dimension, std::size_t length) {
    int variable = 0;
    check_netcdf(nc_def_var(file, name, NC_DOUBLE, 1, &dimension, &variable));
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, &length));
    protect(file, variable);
    return variable;
}

int define_field(int file, const std::array<int, 3>& over, const std::string& name,
                 const Grid& field) {
    int variable = 0;
    check_netcdf(nc_def_var(file, name.c_str(), NC_DOUBLE, 3, over.data(), &variable));
    const std::array<std::size_t, 3> chunk{1, static_cast<std::size_t>(rows_of_chunk(field)),
                                           static_cast<std::size_t>(field.nx())};
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, chunk.data()));
    compress(file, variable);
    protect(file, variable);
    fill_with_nan(file, variable, chunk[1] * chunk[2]);
    return variable;
}

}  // namespace fumon
