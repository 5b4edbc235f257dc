#include "files/netcdf/netcdf_copy.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <vector>

#include "files/netcdf/netcdf_section_record.h"
#include "files/netcdf/number_names.h"

namespace fumon {

namespace {

double number_at(const NetcdfInput& from, int variable, std::size_t record) {
    double value = 0.0;
    check_netcdf(nc_get_var1_double(from.id(), variable, &record, &value));
    return value;
}

int variable_of(const NetcdfInput& from, const std::string& name, std::size_t dimensions) {
    const auto variable = from.find_variable(name);
    if (!variable || from.dimensions(*variable).size() != dimensions)
        throw NetcdfFault("it has no " + name);
    return *variable;
}

bool fits(const SnapshotSection* section, const SectionLayout& layout) {
    return section != nullptr && section->fields.size() == layout.fields.size() &&
           section->curves.size() == layout.curves.size() &&
           section->paths.empty() != layout.paths.has_value();
}

}  // namespace

SourceVariables source_variables(const NetcdfInput& from, const std::vector<std::string>& fields,
                                 const std::vector<std::string>& numbers) {
    constexpr std::size_t over_cells = 3;
    SourceVariables source;
    source.bed = variable_of(from, "bed_height", over_cells);
    for (const std::string& name : fields)
        source.fields.push_back(variable_of(from, name, over_cells));
    for (const std::string& name : numbers)
        source.numbers.push_back(variable_of(from, name_in_file(from, name), 1));
    source.step = variable_of(from, "step", 1);
    source.time = variable_of(from, "time", 1);
    return source;
}

void copy_record(const NetcdfInput& from, const SourceVariables& source, std::size_t record,
                 RecordValues& to, const FieldsLayout& layout, int nx, int ny, std::size_t at) {
    std::vector<double> block;
    const auto copy_field = [&](int variable, int target_variable) {
        for (int y = 0; y < ny; y += layout.rows) {
            const auto rows = static_cast<std::size_t>(std::min(layout.rows, ny - y));
            const auto cells = static_cast<std::size_t>(nx);
            const std::array<std::size_t, 3> start{record, static_cast<std::size_t>(y), 0};
            const std::array<std::size_t, 3> count{1, rows, cells};
            block.resize(rows * cells);
            check_netcdf(
                nc_get_vara_double(from.id(), variable, start.data(), count.data(), block.data()));
            const std::array<std::size_t, 3> target{at, start[1], 0};
            to.put(target_variable, target, count, block.data());
        }
    };
    copy_field(source.bed, layout.bed);
    for (std::size_t i = 0; i < layout.fields.size(); ++i)
        copy_field(source.fields[i], layout.fields[i]);
    for (std::size_t i = 0; i < layout.numbers.size(); ++i)
        to.put(layout.numbers[i], at, number_at(from, source.numbers[i], record));
    if (layout.section) {
        const auto section = read_section(from, record);
        if (!fits(section.get(), *layout.section)) throw NetcdfFault("it has a different section");
        write_section(to, *layout.section, at, *section);
    }
    long long step = 0;
    check_netcdf(nc_get_var1_longlong(from.id(), source.step, &record, &step));
    to.put(layout.step, at, step);
    const double time = number_at(from, source.time, record);
    to.put_derived(layout.date, at, time * layout.date_factor);
    to.put(layout.time, at, time);
}

}  // namespace fumon
