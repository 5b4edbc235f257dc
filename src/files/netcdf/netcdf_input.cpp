#include "files/netcdf/netcdf_input.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cstddef>

#include "base/limits.h"
#include "files/netcdf/netcdf_classic.h"
#include "files/open_files.h"

namespace fumon {

namespace {

struct Attribute {
    nc_type type = NC_NAT;
    std::size_t length = 0;
};

std::optional<Attribute> find_attribute(int file, int variable, const char* name) {
    Attribute attribute;
    const int status = nc_inq_att(file, variable, name, &attribute.type, &attribute.length);
    if (status == NC_ENOTATT) return std::nullopt;
    check_netcdf(status);
    return attribute;
}

bool is_number(int type) {
    return (type >= NC_BYTE && type <= NC_UINT64) && type != NC_CHAR;
}

std::string without_padding(std::string text) {
    while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
    return text;
}

}  // namespace

bool is_netcdf(std::string_view start) {
    constexpr std::string_view hdf5("\x89HDF\r\n\x1a\n", netcdf_signature_length);
    const bool classic = start.size() > 3 && start.starts_with("CDF") &&
                         (start[3] == '\1' || start[3] == '\2' || start[3] == '\5');
    return classic || start.starts_with(hdf5);
}

NetcdfInput::NetcdfInput(const std::filesystem::path& file) : name_(file.string()) {
    refuse_damaged_classic_file(file);
    // An absolute path is never taken for an address on the network.
    try {
        file_ = NetcdfHandle::open_to_read(std::filesystem::absolute(file));
    } catch (const NetcdfFault&) {
        refuse_shortage_of_open_files(file);
        throw;
    }
}

int NetcdfInput::variables() const {
    int count = 0;
    check_netcdf(nc_inq_nvars(id(), &count));
    return count;
}

std::optional<int> NetcdfInput::find_variable(const std::string& name) const {
    int variable = 0;
    const int status = nc_inq_varid(id(), name.c_str(), &variable);
    if (status == NC_ENOTVAR) return std::nullopt;
    check_netcdf(status);
    return variable;
}

std::string NetcdfInput::variable_name(int variable) const {
    std::array<char, NC_MAX_NAME + 1> name{};
    check_netcdf(nc_inq_varname(id(), variable, name.data()));
    return name.data();
}

int NetcdfInput::type(int variable) const {
    nc_type type = NC_NAT;
    check_netcdf(nc_inq_vartype(id(), variable, &type));
    return type;
}

bool NetcdfInput::is_numeric(int variable) const {
    return is_number(type(variable));
}

std::vector<int> NetcdfInput::dimensions(int variable) const {
    int count = 0;
    check_netcdf(nc_inq_varndims(id(), variable, &count));
    std::vector<int> dimensions(static_cast<std::size_t>(count));
    check_netcdf(nc_inq_vardimid(id(), variable, dimensions.data()));
    return dimensions;
}

std::string NetcdfInput::dimension_name(int dimension) const {
    std::array<char, NC_MAX_NAME + 1> name{};
    check_netcdf(nc_inq_dimname(id(), dimension, name.data()));
    return name.data();
}

std::size_t NetcdfInput::dimension_length(int dimension) const {
    std::size_t length = 0;
    check_netcdf(nc_inq_dimlen(id(), dimension, &length));
    return length;
}

std::size_t NetcdfInput::values_over(std::span<const int> dimensions) const {
    constexpr auto most = static_cast<std::size_t>(largest_grid_cells);
    std::size_t count = 1;
    for (const int dimension : dimensions) {
        const std::size_t length = dimension_length(dimension);
        if (length > 0 && count > most / length)
            refuse(fmt::format("has more than {} values in one record", most),
                   "cut out or coarsen the part you need");
        count *= length;
    }
    return count;
}

std::optional<std::string> NetcdfInput::text(int variable, const char* attribute) const {
    const auto found = find_attribute(id(), variable, attribute);
    if (!found) return std::nullopt;
    if (found->type == NC_CHAR) {
        std::string text(found->length, '\0');
        check_netcdf(nc_get_att_text(id(), variable, attribute, text.data()));
        return without_padding(text);
    }
    if (found->type != NC_STRING || found->length != 1) return std::nullopt;
    char* string = nullptr;
    check_netcdf(nc_get_att_string(id(), variable, attribute, &string));
    std::string text = string == nullptr ? "" : string;
    check_netcdf(nc_free_string(1, &string));
    return without_padding(text);
}

std::vector<double> NetcdfInput::numbers(int variable, const char* attribute) const {
    const auto found = find_attribute(id(), variable, attribute);
    if (!found || !is_number(found->type)) return {};
    std::vector<double> values(found->length);
    check_netcdf(nc_get_att_double(id(), variable, attribute, values.data()));
    return values;
}

void NetcdfInput::refuse(std::string_view what, std::string_view remedy) const {
    throw InputError(fmt::format("{}: {}; {}", name_, what, remedy));
}

}  // namespace fumon
