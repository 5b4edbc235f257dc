#include "files/netcdf_record.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <string>

#include "files/netcdf_bed.h"
#include "files/netcdf_input.h"
#include "files/netcdf_section_record.h"
#include "support/error.h"

namespace fumon {

namespace {

bool is_netcdf_file(const std::filesystem::path& file) {
    std::array<char, netcdf_signature_length> start{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(start.data(), start.size());
    return is_netcdf({start.data(), static_cast<std::size_t>(stream.gcount())});
}

Grid field_values(const NetcdfInput& input, int variable, std::size_t record) {
    const std::vector<int> over = input.dimensions(variable);
    if (input.values_over(std::span(over).subspan(1)) == 0) return {};
    const std::size_t ny = input.dimension_length(over[1]);
    const std::size_t nx = input.dimension_length(over[2]);
    Grid values(static_cast<int>(nx), static_cast<int>(ny));
    const std::array<std::size_t, 3> start{record, 0, 0};
    const std::array<std::size_t, 3> count{1, ny, nx};
    check_netcdf(
        nc_get_vara_double(input.id(), variable, start.data(), count.data(), values.data()));
    for (double& value : values.values()) {
        if (std::isnan(value)) value = 0.0;
    }
    return values;
}

std::optional<FieldsRecord> read_record(const NetcdfInput& input) {
    const auto bed = input.find_variable("bed_height");
    const bool is_own = input.text(NC_GLOBAL, "source").value_or("").starts_with("fumon ");
    if (!is_own || !bed) return std::nullopt;
    const std::vector<int> over_bed = input.dimensions(*bed);
    constexpr std::size_t time_y_and_x = 3;
    if (over_bed.size() != time_y_and_x) return std::nullopt;
    const std::size_t records = input.dimension_length(over_bed.front());
    if (records == 0) input.refuse("has no record yet", "let the run write one first");
    FieldsRecord found;
    found.periodic = input.text(NC_GLOBAL, "periodic").value_or("") == "yes";
    for (int variable = 0; variable < input.variables(); ++variable) {
        const std::string name = input.variable_name(variable);
        const std::vector<int> over = input.dimensions(variable);
        const std::string unit = input.text(variable, "units").value_or("1");
        if (over == over_bed && variable != *bed) {
            found.fields.push_back({name, input.text(variable, "long_name").value_or(name), unit,
                                    field_values(input, variable, records - 1)});
        } else if (over == std::vector{over_bed.front()} && name != "time" && name != "step") {
            const std::size_t last = records - 1;
            double value = 0.0;
            check_netcdf(nc_get_var1_double(input.id(), variable, &last, &value));
            found.numbers.push_back({name, unit, value});
        }
    }
    found.section = read_section(input, records - 1);
    return found;
}

}  // namespace

std::optional<FieldsRecord> read_fields_record(const std::filesystem::path& file) {
    if (!is_netcdf_file(file)) return std::nullopt;
    const NetcdfLock lock;
    try {
        return read_record(NetcdfInput(file));
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format("{}: cannot be read as NetCDF: {}; copy it again",
                                     file.string(), fault.what()));
    }
}

}  // namespace fumon
