#include "files/netcdf/netcdf_copy.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "files/netcdf/netcdf_section_record.h"

namespace fumon {

namespace {

void copy_number(const NetcdfInput& from, RecordValues& to, int variable, std::size_t record) {
    double value = 0.0;
    check_netcdf(nc_get_var1_double(from.id(), variable, &record, &value));
    to.put(variable, record, value);
}

bool fits(const SnapshotSection* section, const SectionLayout& layout) {
    return section != nullptr && section->fields.size() == layout.fields.size() &&
           section->curves.size() == layout.curves.size() &&
           section->paths.empty() != layout.paths.has_value();
}

}  // namespace

void copy_record(const NetcdfInput& from, RecordValues& to, const FieldsLayout& layout, int nx,
                 int ny, std::size_t record) {
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
            to.put(variable, start, count, block.data());
        }
    };
    copy_field(layout.bed);
    for (const int field : layout.fields) copy_field(field);
    for (const int number : layout.numbers) copy_number(from, to, number, record);
    if (layout.section) {
        const auto section = read_section(from, record);
        if (!fits(section.get(), *layout.section)) throw NetcdfFault("it has another section");
        write_section(to, *layout.section, record, *section);
    }
    long long step = 0;
    check_netcdf(nc_get_var1_longlong(from.id(), layout.step, &record, &step));
    to.put(layout.step, record, step);
    copy_number(from, to, layout.time, record);
}

std::string copy_records(const std::filesystem::path& former, const FieldsBeginning& beginning,
                         RecordValues& to, const FieldsLayout& layout, int nx, int ny,
                         const std::function<void()>& before) {
    try {
        const NetcdfInput input(former);
        const std::vector<int> over = input.dimensions(layout.time);
        const std::size_t there = over.size() == 1 ? input.dimension_length(over.front()) : 0;
        if (std::cmp_less(there, beginning.records))
            return fmt::format("has {} records of {}", there, beginning.records);
        for (std::size_t record = 0; std::cmp_less(record, beginning.records); ++record) {
            before();
            copy_record(input, to, layout, nx, ny, record);
        }
        return to.hash() == beginning.hash ? "" : "has changed since it was written";
    } catch (const NetcdfFault& fault) {
        return fmt::format("cannot be read: {}", fault.what());
    } catch (const InputError& fault) {
        return fmt::format("cannot be read: {}", fault.what());
    }
}

}  // namespace fumon
