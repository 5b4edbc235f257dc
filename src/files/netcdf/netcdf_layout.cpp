#include "files/netcdf/netcdf_layout.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "base/find_named.h"
#include "base/quantity_text.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_coordinates.h"
#include "files/netcdf/netcdf_definition.h"
#include "files/netcdf/number_names.h"

namespace fumon {

namespace {

constexpr std::size_t chunk_records = 512;  // 4 KiB of a variable over time alone

std::size_t count_of(int cells) {
    return static_cast<std::size_t>(cells);
}

/// A letter first, then letters, digits and underscores, as CF recommends, and points.
void check_names(const Snapshot& first) {
    std::set<std::string> taken{"date", "time", "step", "x", "y", "crs", "bed_height"};
    const auto check = [&](const std::string& name) {
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        const bool fits = !name.empty() && is_letter(name.front()) &&
                          std::all_of(name.begin(), name.end(), [&](char c) {
                              return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '.';
                          });
        if (!fits)
            throw Error(fmt::format(
                "a field is called \"{}\"; NetCDF names are letters, digits and underscores",
                name));
        if (!taken.insert(name).second)
            throw Error(fmt::format("two fields are called \"{}\"; each needs its own name", name));
    };
    for (const SnapshotField& field : first.fields) check(field.name);
    for (const SnapshotNumber& number : first.numbers) check(variable_of_number(number.name));
    if (!first.section) return;
    for (const std::string& name : section_variable_names(*first.section)) check(name);
}

/// As a 32-bit integer where it is one, else as text: CF 1.8 knows no wider integers.
void put_seed(int file, std::int64_t seed) {
    const int number = static_cast<int>(seed);
    if (number != seed) {
        put_text(file, NC_GLOBAL, "seed", fmt::format("{}", seed));
    } else {
        check_netcdf(nc_put_att_int(file, NC_GLOBAL, "seed", NC_INT, 1, &number));
    }
}

void put_global_attributes(int file, const Snapshot& first, const FieldsText& text) {
    put_text(file, NC_GLOBAL, "Conventions", "CF-1.8");
    put_text(file, NC_GLOBAL, "title", text.title);
    put_text(file, NC_GLOBAL, "source", "fumon " FUMON_VERSION);
    put_text(file, NC_GLOBAL, "history",
             text.scene.empty() ? "fumon " FUMON_VERSION " exported it"
                                : "fumon " FUMON_VERSION
                                  " computed it from the scene in the attribute scene");
    if (!text.scene.empty()) put_text(file, NC_GLOBAL, "scene", text.scene);
    put_seed(file, text.seed);
    put_number(file, NC_GLOBAL, "cell_size_x", first.scale.dx);
    put_number(file, NC_GLOBAL, "cell_size_y", first.scale.dy);
    put_text(file, NC_GLOBAL, "cell_size_unit", first.scale.in_metres ? "m" : "sites");
    put_number(file, NC_GLOBAL, "height_unit", first.scale.height_unit);
    put_text(file, NC_GLOBAL, "periodic", first.periodic ? "yes" : "no");
}

struct Dimensions {
    int date = 0;
    int y = 0;
    int x = 0;
};

/// Defines x or y; its values are written by put_centres. Only degrees have the attribute `axis`:
/// VTK and ParaView take an axis X for a longitude, whatever its unit, and bend the map round a
/// sphere.
int define_axis(int file, int dimension, int length, bool eastward, const WorldScale& scale,
                const FileCoordinates& place) {
    const char* name = eastward ? "x" : "y";
    const bool in_metres = scale.in_metres;
    const int variable = define_coordinate(file, name, dimension, count_of(length));
    if (place.degrees) {
        const char* angle = eastward ? "longitude" : "latitude";
        put_text(file, variable, "long_name", angle);
        put_text(file, variable, "units", eastward ? "degrees_east" : "degrees_north");
        put_text(file, variable, "standard_name", angle);
        put_text(file, variable, "axis", eastward ? "X" : "Y");
        return variable;
    }
    put_text(file, variable, "long_name",
             fmt::format("{} {}", in_metres ? "distance" : "site",
                         eastward ? "eastward (downwind)" : "northward"));
    put_text(file, variable, "units", in_metres ? place.unit : "1");
    if (in_metres)
        put_text(file, variable, "standard_name", fmt::format("projection_{}_coordinate", name));
    return variable;
}

/// A row or column alone that lies on no map has none: VTK divides by the number of its intervals
/// and finds no place for it.
bool has_coordinate(int cells, const WorldScale& scale) {
    return cells > 1 || scale.place.has_value();
}

void put_centres(int file, int variable, int count, double begin, double cell_size) {
    std::vector<double> centres(count_of(count));
    for (std::size_t i = 0; i < centres.size(); ++i)
        centres[i] = begin + (static_cast<double>(i) + 0.5) * cell_size;
    check_netcdf(nc_put_var_double(file, variable, centres.data()));
}

int define_over_time(int file, const Dimensions& dimensions, const std::string& name) {
    int variable = 0;
    check_netcdf(nc_def_var(file, name.c_str(), NC_DOUBLE, 1, &dimensions.date, &variable));
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, &chunk_records));
    protect(file, variable);
    return variable;
}

void describe_time(int file, int variable, const std::string& unit) {
    const bool counts_steps = unit_in_file(unit) == "1";
    describe(file, variable, counts_steps ? "step" : "time since the start of the run",
             counts_steps ? "1" : unit);
}

/// A unit of time, and how it is told as a date.
struct DateUnit {
    std::string_view unit;
    std::string_view in_file;
    double factor = 1.0;
};

/// By UDUNITS a year is 365.242198781 days; dates are not told in years, which no calendar has of
/// one length. Whatever counts no time (steps) counts seconds.
DateUnit date_unit(std::string_view unit) {
    constexpr double days_a_year = 365.242198781;
    constexpr std::array<DateUnit, 4> known{
        {{"yr", "days", days_a_year}, {"d", "days"}, {"h", "hours"}, {"min", "minutes"}}};
    const DateUnit* found = find_by(known, &DateUnit::unit, unit);
    return found == nullptr ? DateUnit{unit, "seconds"} : *found;
}

/// The coordinate variable of the records.
void describe_date(int file, int variable, const DateUnit& unit, bool counts_steps) {
    put_text(file, variable, "long_name",
             counts_steps ? "date if the run had begun on 2000-01-01 and a step took a second"
                          : "date if the run had begun on 2000-01-01");
    put_text(file, variable, "standard_name", "time");
    put_text(file, variable, "units", fmt::format("{} since 2000-01-01 00:00:00", unit.in_file));
    put_text(file, variable, "calendar", "standard");
    put_text(file, variable, "axis", "T");
}

}  // namespace

FieldsLayout define_fields(int file, const Snapshot& first, const FieldsText& text) {
    check_names(first);
    put_global_attributes(file, first, text);
    const Grid& bed = first.bed;
    const bool in_metres = first.scale.in_metres;

    Dimensions dimensions;
    check_netcdf(nc_def_dim(file, "date", NC_UNLIMITED, &dimensions.date));
    check_netcdf(nc_def_dim(file, "y", count_of(bed.ny()), &dimensions.y));
    check_netcdf(nc_def_dim(file, "x", count_of(bed.nx()), &dimensions.x));

    const std::array<int, 3> cells{dimensions.date, dimensions.y, dimensions.x};

    FieldsLayout layout;
    layout.rows = rows_of_chunk(bed);
    layout.bed_factor = first.scale.height_unit;
    const std::string time_unit = unit_in_file(first.time_unit);
    const DateUnit date = date_unit(time_unit);
    layout.date_factor = date.factor;
    layout.date = define_over_time(file, dimensions, "date");
    describe_date(file, layout.date, date, time_unit == "1");
    layout.time = define_over_time(file, dimensions, "time");
    describe_time(file, layout.time, first.time_unit);
    layout.step = define_over_time(file, dimensions, "step");
    describe(file, layout.step, "steps done", "1");
    const FileCoordinates place = file_coordinates(first.scale);
    std::optional<int> y;
    if (has_coordinate(bed.ny(), first.scale))
        y = define_axis(file, dimensions.y, bed.ny(), false, first.scale, place);
    std::optional<int> x;
    if (has_coordinate(bed.nx(), first.scale))
        x = define_axis(file, dimensions.x, bed.nx(), true, first.scale, place);
    if (place.has_crs) define_crs(file, first.scale);
    layout.bed = define_field(file, cells, "bed_height", bed);
    describe(file, layout.bed, "height of the bed", in_metres ? "m" : "model heights");
    if (in_metres) put_text(file, layout.bed, "standard_name", "surface_altitude");
    for (const SnapshotField& field : first.fields) {
        layout.fields.push_back(define_field(file, cells, field.name, bed));
        describe(file, layout.fields.back(), field.long_name, field.unit);
    }
    for (const SnapshotNumber& number : first.numbers) {
        layout.numbers.push_back(
            define_over_time(file, dimensions, variable_of_number(number.name)));
        describe(file, layout.numbers.back(), in_words(number.name), number.unit);
    }
    if (first.section) layout.section = define_section(file, dimensions.date, *first.section);
    if (place.has_crs) {
        put_grid_mapping(file, layout.bed);
        for (const int field : layout.fields) put_grid_mapping(file, field);
    }
    check_netcdf(nc_enddef(file));
    if (y) put_centres(file, *y, bed.ny(), place.south, place.dy);
    if (x) put_centres(file, *x, bed.nx(), place.west, place.dx);
    if (layout.section) put_section_coordinates(file, *layout.section, *first.section);
    return layout;
}

namespace {

constexpr std::int64_t index_room = 16 << 10;  // bytes for a variable; 5 KiB were seen at most

std::int64_t variables_of(const Snapshot& first) {
    std::size_t variables = 7 + first.fields.size() + first.numbers.size();
    if (first.section) variables += section_variable_names(*first.section).size();
    return static_cast<std::int64_t>(variables);
}

}  // namespace

std::int64_t header_room(const Snapshot& first, const FieldsText& text) {
    const std::size_t crs = first.scale.place ? first.scale.place->crs.size() : 0;
    const auto characters = static_cast<std::int64_t>(text.title.size() + text.scene.size() +
                                                      (3 + first.fields.size()) * crs);
    std::int64_t nodes = std::int64_t{first.bed.nx()} + first.bed.ny();
    if (first.section) {
        const Grid& field = first.section->fields.front().values;
        nodes += std::int64_t{field.nx()} + field.ny();
    }
    return 2 * characters + 8 * nodes + variables_of(first) * index_room;
}

std::int64_t record_room(const Snapshot& first) {
    const std::int64_t rows = rows_of_chunk(first.bed);
    const std::int64_t whole_rows = (first.bed.ny() + rows - 1) / rows * rows;
    const auto fields = static_cast<std::int64_t>(1 + first.fields.size());
    const std::int64_t section = first.section ? section_record_bytes(*first.section) : 0;
    return fields * whole_rows * first.bed.nx() * 8 + section + variables_of(first) * index_room;
}

}  // namespace fumon
