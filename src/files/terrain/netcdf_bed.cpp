#include "files/terrain/netcdf_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

#include "base/limits.h"
#include "files/crs_kind.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_axis.h"
#include "files/netcdf/netcdf_cells.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_planes.h"
#include "files/netcdf/netcdf_variable.h"
#include "files/terrain/geographic.h"
#include "files/terrain/wanted_unit.h"
#include "files/unit_conversion.h"

namespace fumon {

namespace {

void check_size(const NetcdfInput& input, const BedVariable& bed) {
    const std::size_t nx = input.dimension_length(bed.x);
    const std::size_t ny = input.dimension_length(bed.y);
    if (nx == 0 || ny == 0)
        input.refuse(fmt::format("{} has {} × {} cells", bed.name, nx, ny),
                     "choose a variable that holds heights");
    constexpr auto most = static_cast<std::size_t>(largest_grid_cells);
    if (nx > most || ny > most || nx * ny > most)
        input.refuse(
            fmt::format("{} has {} × {} cells", bed.name, nx, ny),
            fmt::format("at most {} are read; cut out or coarsen the part you need", most));
}

void turn_north_up(Grid& values, bool rows_fall, bool columns_fall) {
    const int ny = values.ny();
    for (int y = 0; rows_fall && y < ny / 2; ++y)
        std::ranges::swap_ranges(values.row(y), values.row(ny - 1 - y));
    for (int y = 0; columns_fall && y < ny; ++y) std::ranges::reverse(values.row(y));
}

/// From raw numbers to what is asked for: packing, unit and direction.
UnitConversion conversion_of(const NetcdfInput& input, const BedVariable& bed,
                             const TerrainQuery& query, Terrain& terrain) {
    const std::string unit = input.text(bed.variable, "units").value_or("");
    auto conversion = conversion_for(query, unit);
    if (!conversion)
        input.refuse(fmt::format("{} is in \"{}\"", bed.name, unit),
                     wanted_units(query, "name another variable by bed.variable"));
    if (const std::string note = conversion_note(query, unit, *conversion); !note.empty())
        add_note(terrain, note);
    if (!query.any_unit && query.height_sign == HeightSign::automatic &&
        grows_downward(input.text(bed.variable, "positive").value_or(""),
                       input.text(bed.variable, "standard_name").value_or(""))) {
        conversion->factor = -conversion->factor;
        conversion->offset = -conversion->offset;
        add_note(terrain, fmt::format("{} grows downward: its numbers are taken as depths "
                                      "(override with bed.height_sign)",
                                      bed.name));
    }
    return *conversion;
}

void convert_values(const NetcdfInput& input, const BedVariable& bed, const TerrainQuery& query,
                    Terrain& terrain) {
    const MissingValues missing = missing_values(input, bed.variable);
    const auto scales = input.numbers(bed.variable, "scale_factor");
    const auto offsets = input.numbers(bed.variable, "add_offset");
    const double scale = scales.empty() ? 1.0 : scales.front();
    const double offset = offsets.empty() ? 0.0 : offsets.front();
    const UnitConversion conversion = conversion_of(input, bed, query, terrain);
    terrain.metres_per_number = conversion.factor;
    Grid& heights = terrain.heights;
    bool any_data = false;
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        double& height = heights.values()[cell];
        if (missing.holds(height)) {
            if (terrain.nodata.empty()) terrain.nodata = Mask(heights.nx(), heights.ny());
            terrain.nodata.values()[cell] = 1;
            height = 0.0;
            continue;
        }
        any_data = true;
        height = conversion(height * scale + offset);
        if (!std::isfinite(height)) {
            const auto nx = static_cast<std::size_t>(heights.nx());
            input.refuse(fmt::format("{} is infinite at row {}, column {} from the south-west",
                                     bed.name, cell / nx + 1, cell % nx + 1),
                         "write a finite number or the _FillValue");
        }
    }
    if (!any_data)
        input.refuse(fmt::format("{} holds no data in any cell", bed.name),
                     "at least one height must differ from the _FillValue");
}

/// A single row or column says nothing of its width: its cells are taken for square.
void complete_spacing(NetcdfAxis& x, NetcdfAxis& y) {
    const auto borrow = [](NetcdfAxis& axis, const NetcdfAxis& other) {
        if (axis.count != 1 || other.spacing == 0.0) return;
        axis.spacing = other.spacing;
        if (!axis.has_coordinates) axis.unit = other.unit;
        axis.has_coordinates = true;
    };
    borrow(x, y);
    borrow(y, x);
}

/// The variable that holds a bed's coordinate reference system.
std::optional<int> crs_holder(const NetcdfInput& input, int variable) {
    std::string mapping = input.text(variable, "grid_mapping").value_or("");
    mapping = mapping.substr(0, mapping.find_first_of(": "));  // "crs: x y" names axes, too
    if (!mapping.empty()) return input.find_variable(mapping);
    for (const char* usual : {"spatial_ref", "crs"}) {  // which xarray does not point at
        if (const auto holder = input.find_variable(usual);
            holder && input.dimensions(*holder).empty())
            return holder;
    }
    return std::nullopt;
}

std::string crs_of(const NetcdfInput& input, int variable) {
    const auto holder = crs_holder(input, variable);
    for (const char* attribute : {"crs_wkt", "spatial_ref"}) {
        std::string text = holder ? input.text(*holder, attribute).value_or("") : "";
        if (!text.empty()) return text;
    }
    for (const char* attribute : {"spatial_ref", "esri_pe_string"}) {
        std::string text = input.text(variable, attribute).value_or("");
        if (!text.empty()) return text;
    }
    return {};
}

void refuse_rotated_pole(const NetcdfInput& input, const BedVariable& bed) {
    const auto holder = crs_holder(input, bed.variable);
    if (!holder ||
        input.text(*holder, "grid_mapping_name").value_or("") != "rotated_latitude_longitude")
        return;
    input.refuse(fmt::format("{} lies on a grid with a rotated pole", bed.name),
                 "interpolate it to a regular grid first (cdo remapbil, gdalwarp or xESMF)");
}

/// The axes by the six numbers of GDAL's GeoTransform, of a grid without coordinates.
void place_by_transform(const NetcdfInput& input, const BedVariable& bed, NetcdfAxis& x,
                        NetcdfAxis& y) {
    const auto holder = crs_holder(input, bed.variable);
    if (!holder || x.has_coordinates || y.has_coordinates) return;
    std::istringstream text(input.text(*holder, "GeoTransform").value_or(""));
    text.imbue(std::locale::classic());
    std::array<double, 6> transform{};
    for (double& number : transform) text >> number;
    if (!text || transform[1] == 0.0 || transform[5] == 0.0) return;
    if (transform[2] != 0.0 || transform[4] != 0.0)
        input.refuse(fmt::format("{} has rotated or skewed cells", bed.name),
                     "warp it to a north-up grid first (gdalwarp)");
    const auto set = [](NetcdfAxis& axis, double edge, double step) {
        const double far = edge + step * static_cast<double>(axis.count);
        axis.has_coordinates = true;
        axis.descending = step < 0.0;
        axis.spacing = std::abs(step);
        axis.lowest = std::min(edge, far) + 0.5 * axis.spacing;
    };
    set(x, transform[0], transform[1]);
    set(y, transform[3], transform[5]);
}

}  // namespace

std::pair<NetcdfAxis, NetcdfAxis> netcdf_axes(const NetcdfInput& input, const BedVariable& bed) {
    refuse_rotated_pole(input, bed);
    NetcdfAxis x = read_netcdf_axis(input, bed.x);
    NetcdfAxis y = read_netcdf_axis(input, bed.y);
    const bool has_location = x.has_coordinates && y.has_coordinates &&
                              x.unit != AxisUnit::unsaid && y.unit != AxisUnit::unsaid;
    if (!has_location) {
        if (auto planes = axes_of_planes(input, bed)) return std::move(*planes);
    }
    place_by_transform(input, bed, x, y);
    return {std::move(x), std::move(y)};
}

namespace {

/// Whether a projected system counts in a unit of so many metres.
bool counts_in(const std::string& crs, double metres) {
    const CrsKind kind = crs_kind(crs);
    return kind.projected && std::abs(kind.metres / metres - 1.0) < 1e-8;
}

/// Where the grid lies, in metres or degrees; none of one in sites or without coordinates.
std::optional<GeoReference> place_of_grid(const NetcdfInput& input, const BedVariable& bed,
                                          const NetcdfAxis& x, const NetcdfAxis& y,
                                          Terrain& terrain) {
    if (!y.has_coordinates)
        add_note(terrain,
                 fmt::format("no coordinates for {}: its first row is taken for the southernmost, "
                             "and the cell size is unknown",
                             y.name));
    if (!x.has_coordinates)
        add_note(terrain, fmt::format("no coordinates for {}: its first column is taken for the "
                                      "westernmost, and the cell size is unknown",
                                      x.name));
    if (!x.has_coordinates || !y.has_coordinates) return std::nullopt;
    if (x.unit != y.unit)
        input.refuse(fmt::format("{} and {} have units of different kinds", x.name, y.name),
                     "both must be lengths, or both degrees");
    if (x.unit == AxisUnit::sites || x.spacing == 0.0 || y.spacing == 0.0) return std::nullopt;
    const GridExtent extent{x.lowest - 0.5 * x.spacing,
                            y.lowest - 0.5 * y.spacing,
                            x.spacing * static_cast<double>(x.count),
                            y.spacing * static_cast<double>(y.count),
                            x.spacing,
                            y.spacing,
                            relief(terrain.heights, terrain.nodata)};
    const bool in_degrees =
        x.unit == AxisUnit::degrees || (x.unit == AxisUnit::unsaid && is_geographic(extent));
    std::string crs = crs_of(input, bed.variable);
    // Places are in the system's own unit: of kilometres of a system in metres these are metres.
    const bool own = x.metres != 1.0 && x.metres == y.metres && counts_in(crs, x.metres);
    const double unit = own ? x.metres : 1.0;
    return GeoReference{extent.west / unit, extent.south / unit, x.spacing / unit,
                        y.spacing / unit,   in_degrees,          std::move(crs)};
}

}  // namespace

Terrain read_netcdf_bed(const NetcdfInput& input, const TerrainQuery& query) {
    const BedVariable bed =
        choose_bed_variable(input, query.variable, {query.record, query.must_name_record});
    check_size(input, bed);
    auto [x, y] = netcdf_axes(input, bed);
    Terrain terrain;
    terrain.note = bed.note;
    terrain.heights = read_cells(input, bed);
    turn_north_up(terrain.heights, y.descending, x.descending);
    convert_values(input, bed, query, terrain);
    complete_spacing(x, y);
    terrain.place = place_of_grid(input, bed, x, y, terrain);
    crop(terrain, query.window, input.name());
    if (terrain.place) {
        terrain.dx = x.spacing;
        terrain.dy = y.spacing;
    }
    return terrain;
}

namespace {

Terrain read_netcdf_format(const std::filesystem::path& file, const TerrainQuery& query) {
    if (!is_netcdf(start_of_input_file(file, netcdf_signature_length))) {
        throw InputError(
            fmt::format("{}: is not a NetCDF file; such a file starts with \"CDF\" or "
                        "\"HDF\", so it may be damaged or have a wrong name",
                        file.string()));
    }
    return read_netcdf_bed(file, query);
}

}  // namespace

Terrain read_netcdf_bed(const std::filesystem::path& file, const TerrainQuery& query) {
    const NetcdfLock lock;
    try {
        return read_netcdf_bed(NetcdfInput(file), query);
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format(
            "{}: cannot be read as NetCDF: {}; it may be cut short, damaged, or still being "
            "written: copy it again",
            file.string(), fault.what()));
    }
}

TerrainFormat netcdf_format() {
    return {.name = netcdf_name,
            .title = "a NetCDF file",
            .is_one =
                [](const std::filesystem::path& file, std::string_view start) {
                    const auto ending = file.extension();
                    return is_netcdf(start) || ending == ".nc" || ending == ".nc4";
                },
            .read = read_netcdf_format,
            .has_units = true,
            .has_variables = true};
}

}  // namespace fumon
