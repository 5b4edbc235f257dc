#include "files/terrain/netcdf_bed.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/limits.h"
#include "files/input_file.h"
#include "files/length_unit.h"
#include "files/netcdf/netcdf_axis.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_variable.h"
#include "files/terrain/geographic.h"

namespace fumon {

namespace {

void add_note(Terrain& terrain, const std::string& note) {
    if (note.empty()) return;
    if (!terrain.note.empty()) terrain.note += "; ";
    terrain.note += note;
}

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

/// "m" of "m above sea level" and "meters (NAVD88)".
std::string without_datum(const std::string& unit) {
    std::size_t end = unit.size();
    for (const char* begin : {" above ", " (", " a.s.l", " asl", " amsl"})
        end = std::min(end, unit.find(begin));
    return unit.substr(0, end);
}

/// Metres per unit of the variable's heights.
double height_factor(const NetcdfInput& input, const BedVariable& bed) {
    const std::string unit = input.text(bed.variable, "units").value_or("");
    if (unit.empty() || unit == "1") return 1.0;
    if (const auto metres = metres_per_unit(without_datum(unit))) return *metres;
    input.refuse(fmt::format("{} is in \"{}\"", bed.name, unit),
                 "heights are in a unit of length (\"m\"); name another variable by bed.variable");
}

/// Which raw values of a variable stand for no data.
struct MissingValues {
    std::vector<double> values;
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool holds(double raw) const {
        if (std::isnan(raw) || raw < lowest || raw > highest) return true;
        return std::find(values.begin(), values.end(), raw) != values.end();
    }
};

/// The default fill value of a type, as a double; none for bytes, which use every value.
std::vector<double> default_fill(int type) {
    switch (type) {
        case NC_SHORT:
            return {NC_FILL_SHORT};
        case NC_USHORT:
            return {NC_FILL_USHORT};
        case NC_INT:
            return {NC_FILL_INT};
        case NC_UINT:
            return {NC_FILL_UINT};
        case NC_INT64:
            return {static_cast<double>(NC_FILL_INT64)};
        case NC_UINT64:
            return {static_cast<double>(NC_FILL_UINT64)};
        case NC_FLOAT:
            return {static_cast<double>(NC_FILL_FLOAT)};
        case NC_DOUBLE:
            return {NC_FILL_DOUBLE};
        default:
            return {};
    }
}

MissingValues missing_values(const NetcdfInput& input, int variable) {
    MissingValues missing{input.numbers(variable, "_FillValue")};
    if (missing.values.empty()) missing.values = default_fill(input.type(variable));
    for (const double value : input.numbers(variable, "missing_value"))
        missing.values.push_back(value);
    const auto range = input.numbers(variable, "valid_range");
    const auto low = input.numbers(variable, "valid_min");
    const auto high = input.numbers(variable, "valid_max");
    if (range.size() == 2) {
        missing.lowest = range[0];
        missing.highest = range[1];
    }
    if (low.size() == 1) missing.lowest = low[0];
    if (high.size() == 1) missing.highest = high[0];
    return missing;
}

/// The raw values of the chosen record, in the file's order.
Grid read_values(const NetcdfInput& input, const BedVariable& bed) {
    const std::size_t nx = input.dimension_length(bed.x);
    const std::size_t ny = input.dimension_length(bed.y);
    Grid values(static_cast<int>(nx), static_cast<int>(ny));
    const std::vector<std::size_t> start = bed.has_records
                                               ? std::vector<std::size_t>{bed.record, 0, 0}
                                               : std::vector<std::size_t>{0, 0};
    const std::vector<std::size_t> count =
        bed.has_records ? std::vector<std::size_t>{1, ny, nx} : std::vector<std::size_t>{ny, nx};
    check_netcdf(
        nc_get_vara_double(input.id(), bed.variable, start.data(), count.data(), values.data()));
    return values;
}

void turn_north_up(Grid& values, bool rows_fall, bool columns_fall) {
    const int ny = values.ny();
    for (int y = 0; rows_fall && y < ny / 2; ++y)
        std::ranges::swap_ranges(values.row(y), values.row(ny - 1 - y));
    for (int y = 0; columns_fall && y < ny; ++y) std::ranges::reverse(values.row(y));
}

void convert_values(const NetcdfInput& input, const BedVariable& bed, bool any_unit,
                    Terrain& terrain) {
    const MissingValues missing = missing_values(input, bed.variable);
    const auto scales = input.numbers(bed.variable, "scale_factor");
    const auto offsets = input.numbers(bed.variable, "add_offset");
    const double scale = scales.empty() ? 1.0 : scales.front();
    const double offset = offsets.empty() ? 0.0 : offsets.front();
    const double metres = any_unit ? 1.0 : height_factor(input, bed);
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
        height = (height * scale + offset) * metres;
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
    if (metres != 1.0)
        add_note(terrain, fmt::format("heights converted to metres from {}",
                                      *input.text(bed.variable, "units")));
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

/// The coordinate reference system of a variable as CF tells it; empty where it does not.
std::string crs_of(const NetcdfInput& input, int variable) {
    const auto mapping = input.text(variable, "grid_mapping");
    const auto holder = mapping ? input.find_variable(*mapping) : std::nullopt;
    if (!holder) return input.text(variable, "spatial_ref").value_or("");
    const auto crs = input.text(*holder, "crs_wkt");
    return crs ? *crs : input.text(*holder, "spatial_ref").value_or("");
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
                     "both are lengths, or both degrees");
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
    return GeoReference{extent.west, extent.south, x.spacing,
                        y.spacing,   in_degrees,   crs_of(input, bed.variable)};
}

void set_cell_sizes(const NetcdfInput& input, Terrain& terrain) {
    if (!terrain.place) return;
    const GeoReference& place = *terrain.place;
    terrain.dx = place.dx;
    terrain.dy = place.dy;
    if (!place.degrees) return;
    const double middle = place.south + 0.5 * place.dy * terrain.heights.ny();
    if (std::abs(middle) >= 90.0)
        input.refuse(fmt::format("the middle latitude is {:.6g}°", middle),
                     "latitudes lie between -90 and 90");
    const MetricCells cells = cells_from_degrees(place.dx, place.dy, middle);
    terrain.dx = cells.dx;
    terrain.dy = cells.dy;
    add_note(terrain, cells.note);
}

Terrain read_bed(const NetcdfInput& input, const TerrainQuery& query) {
    const BedVariable bed =
        choose_bed_variable(input, query.variable, {query.record, query.must_name_record});
    check_size(input, bed);
    NetcdfAxis x = read_netcdf_axis(input, bed.x);
    NetcdfAxis y = read_netcdf_axis(input, bed.y);
    Terrain terrain;
    terrain.note = bed.note;
    terrain.heights = read_values(input, bed);
    turn_north_up(terrain.heights, y.descending, x.descending);
    convert_values(input, bed, query.any_unit, terrain);
    complete_spacing(x, y);
    terrain.place = place_of_grid(input, bed, x, y, terrain);
    crop(terrain, query.window, input.name());
    set_cell_sizes(input, terrain);
    return terrain;
}

Terrain read_netcdf_format(const std::filesystem::path& file, const TerrainQuery& query) {
    if (!is_netcdf(start_of_input_file(file, netcdf_signature_length))) {
        throw InputError(
            fmt::format("{}: is not a NetCDF file; such a file starts with \"CDF\" or "
                        "\"HDF\", so it may be damaged or bear a wrong name",
                        file.string()));
    }
    return read_netcdf_bed(file, query);
}

}  // namespace

Terrain read_netcdf_bed(const std::filesystem::path& file, const TerrainQuery& query) {
    const NetcdfLock lock;
    try {
        return read_bed(NetcdfInput(file), query);
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format(
            "{}: cannot be read as NetCDF: {}; it may be cut short, damaged, or still being "
            "written: copy it again",
            file.string(), fault.what()));
    }
}

TerrainFormat netcdf_format() {
    return {.name = "netcdf",
            .title = "a NetCDF file",
            .is_one =
                [](const std::filesystem::path& file, std::string_view start) {
                    const auto ending = file.extension();
                    return is_netcdf(start) || ending == ".nc" || ending == ".nc4";
                },
            .read = read_netcdf_format,
            .has_variables = true};
}

}  // namespace fumon
