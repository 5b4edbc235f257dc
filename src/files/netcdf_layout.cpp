#include "files/netcdf_layout.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>

#include "files/netcdf_calls.h"

namespace fumon {

namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20;  // of a field's chunk, at most about
constexpr std::size_t chunk_records = 512;                 // 4 KiB of a variable over time alone
constexpr int compression = 1;  // deflate level: most of the gain at a third of level 6's time

std::size_t count_of(int cells) {
    return static_cast<std::size_t>(cells);
}

/// Rows of a chunk: blocks as even as the number of rows allows.
int rows_of_chunk(const Grid& bed) {
    const std::size_t row_bytes = count_of(bed.nx()) * sizeof(double);
    const int most =
        static_cast<int>(std::clamp(chunk_bytes / row_bytes, std::size_t{1}, count_of(bed.ny())));
    const int blocks = (bed.ny() + most - 1) / most;
    return (bed.ny() + blocks - 1) / blocks;
}

void put_text(int file, int variable, const char* name, std::string_view text) {
    check_netcdf(nc_put_att_text(file, variable, name, text.size(), text.data()));
}

void put_number(int file, int variable, const char* name, double value) {
    check_netcdf(nc_put_att_double(file, variable, name, NC_DOUBLE, 1, &value));
}

/// A unit as udunits knows it.
std::string unit_in_file(const std::string& unit) {
    constexpr std::array<std::pair<std::string_view, const char*>, 20> known{{
        {"", "1"},        {"step", "1"},   {"steps", "1"},         {"site", "1"},
        {"sites", "1"},   {"height", "1"}, {"heights", "1"},       {"model height", "1"},
        {"cell", "1"},    {"cells", "1"},  {"model heights", "1"}, {"grain", "1"},
        {"grains", "1"},  {"round", "1"},  {"rounds", "1"},        {"times", "1"},
        {"seconds", "s"}, {"hours", "h"},  {"minutes", "min"},     {"days", "d"},
    }};
    const auto* found = std::find_if(known.begin(), known.end(),
                                     [&](const auto& entry) { return entry.first == unit; });
    return found == known.end() ? unit : found->second;
}

void describe(int file, int variable, const std::string& long_name, const std::string& unit) {
    const std::string in_file = unit_in_file(unit);
    const bool says_less = in_file == "1" && unit != "1" && !unit.empty();
    put_text(file, variable, "long_name",
             says_less ? fmt::format("{} ({})", long_name, unit) : long_name);
    put_text(file, variable, "units", in_file);
}

/// CF asks for letters, digits and underscores, a letter first.
void check_names(const Snapshot& first) {
    std::set<std::string> taken{"time", "step", "x", "y", "bed_height"};
    const auto check = [&](const std::string& name) {
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        const bool fits = !name.empty() && is_letter(name.front()) &&
                          std::all_of(name.begin(), name.end(), [&](char c) {
                              return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
                          });
        if (!fits)
            throw Error(fmt::format(
                "a field is called \"{}\"; NetCDF names are letters, digits and underscores",
                name));
        if (!taken.insert(name).second)
            throw Error(fmt::format("two fields are called \"{}\"; each needs its own name", name));
    };
    for (const SnapshotField& field : first.fields) check(field.name);
    for (const SnapshotNumber& number : first.numbers) check(number.name);
}

void put_global_attributes(int file, const Snapshot& first, const FieldsText& text) {
    put_text(file, NC_GLOBAL, "Conventions", "CF-1.9");
    put_text(file, NC_GLOBAL, "title", text.title);
    put_text(file, NC_GLOBAL, "source", "fumon " FUMON_VERSION);
    put_text(file, NC_GLOBAL, "history",
             "fumon " FUMON_VERSION " computed it from the scene in the attribute scene");
    put_text(file, NC_GLOBAL, "scene", text.scene);
    const long long seed = text.seed;
    check_netcdf(nc_put_att_longlong(file, NC_GLOBAL, "seed", NC_INT64, 1, &seed));
    put_number(file, NC_GLOBAL, "cell_size_x", first.scale.dx);
    put_number(file, NC_GLOBAL, "cell_size_y", first.scale.dy);
    put_text(file, NC_GLOBAL, "cell_size_unit", first.scale.in_metres ? "m" : "sites");
    put_number(file, NC_GLOBAL, "height_unit", first.scale.height_unit);
    put_text(file, NC_GLOBAL, "periodic", first.periodic ? "yes" : "no");
}

struct Dimensions {
    int time = 0;
    int y = 0;
    int x = 0;
};

/// Defines x or y; its values are written by put_centres.
int define_axis(int file, int dimension, std::string_view axis, bool in_metres) {
    const bool eastward = axis == "X";
    const char* name = eastward ? "x" : "y";
    int variable = 0;
    check_netcdf(nc_def_var(file, name, NC_DOUBLE, 1, &dimension, &variable));
    describe(file, variable,
             fmt::format("{} {}", in_metres ? "distance" : "site",
                         eastward ? "eastward (downwind)" : "northward"),
             in_metres ? "m" : "1");
    if (in_metres)
        put_text(file, variable, "standard_name", fmt::format("projection_{}_coordinate", name));
    put_text(file, variable, "axis", axis);
    return variable;
}

void put_centres(int file, int variable, int count, double cell_size) {
    std::vector<double> centres(count_of(count));
    for (std::size_t i = 0; i < centres.size(); ++i)
        centres[i] = (static_cast<double>(i) + 0.5) * cell_size;
    check_netcdf(nc_put_var_double(file, variable, centres.data()));
}

int define_over_time(int file, const Dimensions& dimensions, const std::string& name, int type) {
    int variable = 0;
    check_netcdf(nc_def_var(file, name.c_str(), type, 1, &dimensions.time, &variable));
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, &chunk_records));
    return variable;
}

int define_field(int file, const Dimensions& dimensions, const std::string& name, const Grid& bed,
                 int rows) {
    int variable = 0;
    const std::array<int, 3> over{dimensions.time, dimensions.y, dimensions.x};
    check_netcdf(nc_def_var(file, name.c_str(), NC_DOUBLE, 3, over.data(), &variable));
    const std::array<std::size_t, 3> chunk{1, count_of(rows), count_of(bed.nx())};
    check_netcdf(nc_def_var_chunking(file, variable, NC_CHUNKED, chunk.data()));
    constexpr int shuffle = 1;
    constexpr int deflate = 1;
    check_netcdf(nc_def_var_deflate(file, variable, shuffle, deflate, compression));
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    check_netcdf(nc_def_var_fill(file, variable, NC_FILL, &not_a_number));
    // A chunk is written whole, once, and never read again: the library's own cache of 16 MiB for
    // every variable would only take memory.
    constexpr std::size_t slots = 11;
    constexpr float preemption = 1.0F;
    check_netcdf(nc_set_var_chunk_cache(file, variable, chunk[1] * chunk[2] * sizeof(double), slots,
                                        preemption));
    return variable;
}

void describe_time(int file, int variable, const std::string& unit) {
    const bool counts_steps = unit_in_file(unit) == "1";
    describe(file, variable, counts_steps ? "step" : "time since the start of the run",
             counts_steps ? "1" : unit);
    if (!counts_steps) put_text(file, variable, "axis", "T");
}

}  // namespace

FieldsLayout define_fields(int file, const Snapshot& first, const FieldsText& text) {
    check_names(first);
    put_global_attributes(file, first, text);
    const Grid& bed = first.bed;
    const bool in_metres = first.scale.in_metres;

    Dimensions dimensions;
    check_netcdf(nc_def_dim(file, "time", NC_UNLIMITED, &dimensions.time));
    check_netcdf(nc_def_dim(file, "y", count_of(bed.ny()), &dimensions.y));
    check_netcdf(nc_def_dim(file, "x", count_of(bed.nx()), &dimensions.x));

    FieldsLayout layout;
    layout.rows = rows_of_chunk(bed);
    layout.bed_factor = first.scale.height_unit;
    layout.time = define_over_time(file, dimensions, "time", NC_DOUBLE);
    describe_time(file, layout.time, first.time_unit);
    layout.step = define_over_time(file, dimensions, "step", NC_INT64);
    describe(file, layout.step, "steps done", "1");
    const int y = define_axis(file, dimensions.y, "Y", in_metres);
    const int x = define_axis(file, dimensions.x, "X", in_metres);
    layout.bed = define_field(file, dimensions, "bed_height", bed, layout.rows);
    describe(file, layout.bed, "height of the bed", in_metres ? "m" : "model heights");
    if (in_metres) put_text(file, layout.bed, "standard_name", "surface_altitude");
    for (const SnapshotField& field : first.fields) {
        layout.fields.push_back(define_field(file, dimensions, field.name, bed, layout.rows));
        describe(file, layout.fields.back(), field.long_name, field.unit);
    }
    for (const SnapshotNumber& number : first.numbers) {
        layout.numbers.push_back(define_over_time(file, dimensions, number.name, NC_DOUBLE));
        std::string words = number.name;
        std::replace(words.begin(), words.end(), '_', ' ');
        describe(file, layout.numbers.back(), words, number.unit);
    }
    check_netcdf(nc_enddef(file));
    put_centres(file, y, bed.ny(), first.scale.dy);
    put_centres(file, x, bed.nx(), first.scale.dx);
    return layout;
}

namespace {

constexpr std::int64_t index_room = 16 << 10;  // bytes for a variable; 5 KiB were seen at most

std::int64_t variables_of(const Snapshot& first) {
    return static_cast<std::int64_t>(5 + first.fields.size() + first.numbers.size());
}

}  // namespace

std::int64_t header_room(const Snapshot& first, const FieldsText& text) {
    const auto characters = static_cast<std::int64_t>(text.title.size() + text.scene.size());
    const std::int64_t coordinates = std::int64_t{8} * (first.bed.nx() + first.bed.ny());
    return 2 * characters + coordinates + variables_of(first) * index_room;
}

std::int64_t record_room(const Snapshot& first) {
    const std::int64_t rows = rows_of_chunk(first.bed);
    const std::int64_t whole_rows = (first.bed.ny() + rows - 1) / rows * rows;
    const auto fields = static_cast<std::int64_t>(1 + first.fields.size());
    return fields * whole_rows * first.bed.nx() * 8 + variables_of(first) * index_room;
}

}  // namespace fumon
