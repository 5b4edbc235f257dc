#include "files/netcdf/netcdf_record.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_section_record.h"
#include "files/netcdf/number_names.h"

namespace fumon {

namespace {

bool is_netcdf_file(const std::filesystem::path& file) {
    std::error_code fault;
    return std::filesystem::is_regular_file(file, fault) &&
           is_netcdf(start_of_input_file(file, netcdf_signature_length));
}

/// NaN in cells without data.
Grid values_with_gaps(const NetcdfInput& input, int variable, std::size_t record) {
    const std::vector<int> over = input.dimensions(variable);
    if (input.values_over(std::span(over).subspan(1)) == 0) return {};
    const std::size_t ny = input.dimension_length(over[1]);
    const std::size_t nx = input.dimension_length(over[2]);
    Grid values(static_cast<int>(nx), static_cast<int>(ny));
    const std::array<std::size_t, 3> start{record, 0, 0};
    const std::array<std::size_t, 3> count{1, ny, nx};
    check_netcdf(
        nc_get_vara_double(input.id(), variable, start.data(), count.data(), values.data()));
    return values;
}

Grid field_values(const NetcdfInput& input, int variable, std::size_t record) {
    Grid values = values_with_gaps(input, variable, record);
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
        } else if (over == std::vector{over_bed.front()} && name != "date" && name != "time" &&
                   name != "step") {
            const std::size_t last = records - 1;
            double value = 0.0;
            check_netcdf(nc_get_var1_double(input.id(), variable, &last, &value));
            found.numbers.push_back({name, unit, value});
        }
    }
    found.section = read_section(input, records - 1);
    return found;
}

/// The record of a step, by bisection: steps ascend, and a damaged file may claim any number of
/// them.
std::size_t record_of(const NetcdfInput& input, std::int64_t step) {
    const auto variable = input.find_variable("step");
    if (!variable || input.dimensions(*variable).size() != 1)
        input.refuse("is not a fields file written by fumon", "delete it");
    const auto step_of = [&](std::size_t record) {
        long long value = 0;
        check_netcdf(nc_get_var1_longlong(input.id(), *variable, &record, &value));
        return std::int64_t{value};
    };
    const std::size_t records = input.dimension_length(input.dimensions(*variable).front());
    std::size_t first = 0;
    std::size_t end = records;
    while (first < end) {
        const std::size_t middle = first + (end - first) / 2;
        if (step_of(middle) < step) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    if (first < records && step_of(first) == step) return first;
    std::string nearest = records == 0 ? "it has none at all" : "its nearest is of step";
    if (first > 0) nearest += fmt::format(" {}", step_of(first - 1));
    if (first > 0 && first < records) nearest += " or";
    if (first < records) nearest += fmt::format(" {}", step_of(first));
    input.refuse(fmt::format("has no record of step {}", step), nearest);
}

std::vector<FieldsMoment> moments_of(const NetcdfInput& input) {
    const auto step = input.find_variable("step");
    const auto time = input.find_variable("time");
    if (!step || !time || input.dimensions(*step).size() != 1 ||
        input.dimensions(*time) != input.dimensions(*step))
        input.refuse("is not a fields file written by fumon", "use the file that the run wrote");
    const std::vector<int> over = input.dimensions(*step);
    const std::size_t records = input.values_over(over);
    std::vector<FieldsMoment> moments(records);
    for (std::size_t record = 0; record < records; ++record) {
        long long value = 0;
        check_netcdf(nc_get_var1_longlong(input.id(), *step, &record, &value));
        moments[record].step = value;
        check_netcdf(nc_get_var1_double(input.id(), *time, &record, &moments[record].time));
    }
    return moments;
}

int variable_of(const NetcdfInput& input, const std::string& name) {
    const auto variable = input.find_variable(name);
    if (!variable)
        input.refuse(fmt::format("has no {}", name), "it belongs to another run: delete it");
    return *variable;
}

double number_at(const NetcdfInput& input, const std::string& name, std::size_t record) {
    const int variable = variable_of(input, name);
    if (input.dimensions(variable).size() != 1)
        input.refuse(fmt::format("has no {} of a step", name),
                     "it belongs to another run: delete it");
    double value = 0.0;
    check_netcdf(nc_get_var1_double(input.id(), variable, &record, &value));
    return value;
}

void check_size(const NetcdfInput& input, const Grid& values, const Grid& bed) {
    if (values.nx() == bed.nx() && values.ny() == bed.ny()) return;
    input.refuse("has another size", "it belongs to another run: delete it");
}

/// The bed of a record, and where it has none the mask.
void read_bed(const NetcdfInput& input, std::size_t record, Snapshot& snapshot) {
    const Grid heights = values_with_gaps(input, variable_of(input, "bed_height"), record);
    check_size(input, heights, snapshot.bed);
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        const double height = heights.values()[cell];
        const bool outside = std::isnan(height);
        snapshot.bed.values()[cell] = outside ? 0.0 : height / snapshot.scale.height_unit;
        if (!snapshot.nodata.empty())
            snapshot.nodata.values()[cell] = static_cast<std::uint8_t>(outside);
    }
}

Snapshot snapshot_at(const NetcdfInput& input, std::int64_t step, Snapshot snapshot) {
    const std::size_t record = record_of(input, step);
    snapshot.step = step;
    snapshot.time = number_at(input, "time", record);
    read_bed(input, record, snapshot);
    for (SnapshotField& field : snapshot.fields) {
        field.values = field_values(input, variable_of(input, field.name), record);
        check_size(input, field.values, snapshot.bed);
    }
    for (SnapshotNumber& number : snapshot.numbers)
        number.value = number_at(input, name_in_file(input, number.name), record);
    if (snapshot.section) snapshot.section = read_section(input, record);
    return snapshot;
}

/// Reads with the library's lock held.
template <class Reading>
auto locked(const std::filesystem::path& file, const Reading& reading) {
    const NetcdfLock lock;
    try {
        return reading(NetcdfInput(file));
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format("{}: cannot be read as NetCDF: {}; copy it again",
                                     file.string(), fault.what()));
    }
}

}  // namespace

std::vector<FieldsMoment> read_fields_moments(const std::filesystem::path& file) {
    return locked(file, [](const NetcdfInput& input) { return moments_of(input); });
}

std::string read_fields_scene(const std::filesystem::path& file) {
    return locked(file, [](const NetcdfInput& input) {
        auto scene = input.text(NC_GLOBAL, "scene");
        if (!scene) input.refuse("holds no scene", "use the file that the run wrote");
        return *std::move(scene);
    });
}

std::string read_fields_version(const std::filesystem::path& file) {
    return locked(file, [](const NetcdfInput& input) {
        constexpr std::string_view name = "fumon ";
        const std::string source = input.text(NC_GLOBAL, "source").value_or("");
        return source.starts_with(name) ? source.substr(name.size()) : std::string();
    });
}

Snapshot read_fields_snapshot(const std::filesystem::path& file, std::int64_t step,
                              Snapshot outline) {
    return locked(file, [&](const NetcdfInput& input) {
        return snapshot_at(input, step, std::move(outline));
    });
}

std::optional<FieldsRecord> read_fields_record(const std::filesystem::path& file) {
    if (!is_netcdf_file(file)) return std::nullopt;
    return locked(file, [](const NetcdfInput& input) { return read_record(input); });
}

bool is_fields_file(const std::filesystem::path& file) {
    return is_netcdf(start_of_input_file(file, netcdf_signature_length)) &&
           read_fields_record(file).has_value();
}

}  // namespace fumon
