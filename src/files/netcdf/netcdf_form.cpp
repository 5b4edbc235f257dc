#include "files/netcdf/netcdf_form.h"

#include <fmt/format.h>

#include <string_view>

#include "base/error.h"

namespace fumon {

namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
    std::vector<std::string> names;
    names.reserve(list.size());
    for (const Named& entry : list) names.push_back(entry.name);
    return names;
}

std::optional<SectionForm> form_of(const SnapshotSection* section) {
    if (section == nullptr) return std::nullopt;
    return SectionForm{section->dx,
                       section->dz,
                       section->fields.empty() ? 0 : section->fields.front().values.ny(),
                       names_of(section->fields),
                       names_of(section->curves),
                       section->paths.size()};
}

bool has_size(const Grid& grid, const RecordForm& form) {
    return grid.nx() == form.nx && grid.ny() == form.ny;
}

[[noreturn]] void refuse_form(const std::filesystem::path& file, std::string_view what) {
    throw Error(fmt::format("cannot write {}: {}; all records of a file must have the same form",
                            file.string(), what));
}

void check_whole_section(const std::filesystem::path& file, const RecordForm& form,
                         const SnapshotSection& section) {
    constexpr int fewest = 2;  // nodes from which a spacing can be told
    const int nz = form.section->nz;
    if (form.ny != 1 || form.nx < fewest || nz < fewest)
        refuse_form(file,
                    fmt::format("a section of {} x {} nodes lies over a bed of {} x {} cells; a "
                                "section needs 2 x 2 nodes or more, and a bed of one row",
                                form.nx, nz, form.nx, form.ny));
    for (const SnapshotField& field : section.fields) {
        if (field.values.nx() != form.nx || field.values.ny() != nz)
            refuse_form(file, fmt::format("{} has {} x {} nodes, the section {} x {}", field.name,
                                          field.values.nx(), field.values.ny(), form.nx, nz));
    }
    for (const SectionCurve& curve : section.curves) {
        if (curve.values.size() != static_cast<std::size_t>(form.nx))
            refuse_form(file, fmt::format("{} has {} values, the section {} columns", curve.name,
                                          curve.values.size(), form.nx));
    }
    for (const GrainPath& path : section.paths) {
        if (path.x.size() != path.z.size())
            refuse_form(file,
                        fmt::format("a path has {} x and {} z", path.x.size(), path.z.size()));
    }
}

void check_whole_snapshot(const std::filesystem::path& file, const RecordForm& form,
                          const Snapshot& snapshot) {
    if (snapshot.bed.empty()) refuse_form(file, "the bed has no cells");
    for (const SnapshotField& field : snapshot.fields) {
        if (!has_size(field.values, form))
            refuse_form(file, fmt::format("{} has {} x {} cells, the bed {} x {}", field.name,
                                          field.values.nx(), field.values.ny(), form.nx, form.ny));
    }
    if (!snapshot.nodata.empty() &&
        (snapshot.nodata.nx() != form.nx || snapshot.nodata.ny() != form.ny))
        refuse_form(file, "the mask's size is not the bed's");
    if (snapshot.section) check_whole_section(file, form, *snapshot.section);
}

}  // namespace

RecordForm record_form(const Snapshot& snapshot) {
    return {snapshot.bed.nx(),         snapshot.bed.ny(),          snapshot.scale,
            names_of(snapshot.fields), names_of(snapshot.numbers), form_of(snapshot.section.get())};
}

void check_whole(const std::filesystem::path& file, const Snapshot& snapshot) {
    check_whole_snapshot(file, record_form(snapshot), snapshot);
}

void check_form(const std::filesystem::path& file, const RecordForm& form,
                const Snapshot& snapshot) {
    const RecordForm now = record_form(snapshot);
    if (!has_size(snapshot.bed, form))
        refuse_form(file, fmt::format("step {} has {} x {} cells, the file {} x {}", snapshot.step,
                                      now.nx, now.ny, form.nx, form.ny));
    if (now.scale != form.scale)
        refuse_form(file, fmt::format("step {} has another scale", snapshot.step));
    if (now.fields != form.fields || now.numbers != form.numbers)
        refuse_form(file, fmt::format("step {} has other fields or numbers", snapshot.step));
    if (now.section != form.section)
        refuse_form(file,
                    fmt::format("step {} has another section, in its spacing, fields, curves or "
                                "number of paths",
                                snapshot.step));
    check_whole_snapshot(file, form, snapshot);
}

Snapshot outline_of(const Snapshot& snapshot) {
    Snapshot outline;
    outline.time_unit = snapshot.time_unit;
    outline.bed = snapshot.bed;
    outline.scale = snapshot.scale;
    outline.periodic = snapshot.periodic;
    outline.section = snapshot.section;
    for (const SnapshotField& field : snapshot.fields)
        outline.fields.push_back({field.name, field.long_name, field.unit, {}});
    outline.numbers = snapshot.numbers;
    return outline;
}

}  // namespace fumon
