#include "rasters/raster_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "files/netcdf/netcdf_fields.h"
#include "files/netcdf/netcdf_record.h"

namespace fumon {

namespace {

/// The first record of a run whose fields.nc this is; none of another file.
std::optional<Snapshot> first_record(const RasterRequest& request, const Snapshot& last) {
    const std::string& file = request.input;
    if (!is_fields_file(file)) return std::nullopt;
    const std::vector<FieldsMoment> moments = read_fields_moments(file);
    Snapshot first = read_fields_snapshot(file, moments.front().step, last);
    const bool fits = first.bed.nx() == last.bed.nx() && first.bed.ny() == last.bed.ny();
    return fits ? std::optional(std::move(first)) : std::nullopt;
}

Raster raster_of(const RasterRequest& request, const Snapshot& snapshot) {
    std::optional<Snapshot> first;
    if (request.field == "change") first = first_record(request, snapshot);
    try {
        return make_raster(request.field, {snapshot, first ? &*first : nullptr, request.light});
    } catch (const InputError& refusal) {
        throw InputError(fmt::format("{}: --field: {}", request.input, refusal.what()));
    }
}

}  // namespace

std::vector<std::string> raster_names() {
    std::vector<std::string> names;
    for (const RasterQuantity& quantity : raster_quantities()) names.emplace_back(quantity.name);
    return names;
}

std::string raster_help() {
    std::string text = "--field takes, for .tif, .cog.tif, .asc and .nc:\n";
    for (const RasterQuantity& quantity : raster_quantities())
        text += fmt::format("  {:<13}   {}\n", quantity.name, quantity.help);
    return text + "  and every field of a run's fields.nc by its own name.\n";
}

std::vector<TerrainBytes> raster_files(const RasterRequest& request, const Snapshot& snapshot,
                                       std::string_view format) {
    const Raster raster = raster_of(request, snapshot);
    return find_written_format(format)->write({raster.values, raster.nodata, snapshot.scale,
                                               fmt::format("{}: {}", raster.name, raster.long_name),
                                               raster.unit});
}

void write_raster_netcdf(const RasterRequest& request, Snapshot snapshot,
                         const std::filesystem::path& file) {
    if (!request.field.empty()) {
        Raster raster = raster_of(request, snapshot);
        for (std::size_t cell = 0; cell < raster.nodata.size(); ++cell) {
            if (raster.nodata.values()[cell] != 0)
                raster.values.values()[cell] = std::numeric_limits<double>::quiet_NaN();
        }
        std::ranges::replace(raster.name, '-', '_');
        snapshot.numbers.clear();
        snapshot.section.reset();
        snapshot.fields.clear();
        if (raster.name != "height") {
            snapshot.fields.push_back({std::move(raster.name), std::move(raster.long_name),
                                       std::move(raster.unit), std::move(raster.values)});
        }
    }
    if (!is_fields_file(request.input)) snapshot.periodic = false;
    const std::string title = request.field.empty() ? "terrain" : request.field;
    FieldsFile fields(file, snapshot, {.title = title, .scene = {}});
    fields.add(snapshot);
    fields.commit();
}

}  // namespace fumon
