#include "files/netcdf/netcdf_copy.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <vector>

#include "files/netcdf/netcdf_section_record.h"

namespace fumon {

namespace {

void copy_number(const NetcdfInput& from, std::size_t record, RecordValues& to, int variable,
                 std::size_t at) {
    double value = 0.0;
    check_netcdf(nc_get_var1_double(from.id(), variable, &record, &value));
    to.put(variable, at, value);
}

bool fits(const SnapshotSection* section, const SectionLayout& layout) {
    return section != nullptr && section->fields.size() == layout.fields.size() &&
           section->curves.size() == layout.curves.size() &&
           section->paths.empty() != layout.paths.has_value();
}

}  // namespace

void copy_record(const NetcdfInput& from, std::size_t record, RecordValues& to,
                 const FieldsLayout& layout, int nx, int ny, std::size_t at) {
    std::vector<double> block;
    const auto copy_field = [&](int variable) {
        for (int y = 0; y < ny; y += layout.rows) {
            const auto rows = static_cast<std::size_t>(std::min(layout.rows, ny - y));
            const auto cells = static_cast<std::size_t>(nx);
            const std::array<std::size_t, 3> start{record, static_cast<std::size_t>(y), 0};
            const std::array<std::size_t, 3> count{1, rows, cells};
            block.resize(rows * cells);
            check_netcdf(
                nc_get_vara_double(from.id(), variable, start.data(), count.data(), block.data()));
            const std::array<std::size_t, 3> target{at, start[1], 0};
            to.put(variable, target, count, block.data());
        }
    };
    copy_field(layout.bed);
    for (const int field : layout.fields) copy_field(field);
    for (const int number : layout.numbers) copy_number(from, record, to, number, at);
    if (layout.section) {
        const auto section = read_section(from, record);
        if (!fits(section.get(), *layout.section)) throw NetcdfFault("it has another section");
        write_section(to, *layout.section, at, *section);
    }
    long long step = 0;
    check_netcdf(nc_get_var1_longlong(from.id(), layout.step, &record, &step));
    to.put(layout.step, at, step);
    copy_number(from, record, to, layout.time, at);
}

}  // namespace fumon
