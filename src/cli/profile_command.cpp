#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "cli/snapshot_argument.h"
#include "figure/page/page.h"
#include "figure/panels/profile_panel.h"
#include "files/atomic_file.h"
#include "files/csv_table.h"
#include "measure/network/polyline_samples.h"
#include "measure/network/stream_path.h"
#include "outputs/output_claims.h"
#include "picture/png.h"
#include "run/inputs/scene_argument.h"
#include "run/still.h"

namespace fumon {

namespace {

struct ProfileOptions {
    std::string input;               ///< a run's folder, a fields.nc or a terrain file
    std::string from;                ///< "x,y"; empty: the head of the longest way down
    std::vector<std::string> along;  ///< "x,y" each: a line instead of a stream
    bool on_map = false;             ///< in the file's coordinates
    std::string table;               ///< a CSV; empty: standard output
    std::string picture;             ///< a PNG, PDF or SVG; empty: none
    double exaggeration = 0;         ///< 0: as large as the frame allows
    bool force = false;
    std::vector<std::string> settings;
};

/// Of a line.
constexpr int most_corners = 10'000;

void declare(CLI::App& command, ProfileOptions& options) {
    command
        .add_option("RUN", options.input,
                    "a run's folder (its fields.nc, else its last bed), a fields.nc, or terrain")
        ->required();
    command
        .add_option("--from", options.from,
                    "where the stream begins: metres east and north of the bed's south-west corner "
                    "(default: at the head of the longest)")
        ->type_name("X,Y");
    auto* from = command.get_option("--from");
    command
        .add_option("--along", options.along,
                    "a line through these places, instead of a stream: two or more, as --from")
        ->type_name("X,Y")
        ->expected(2, most_corners)
        ->excludes(from);
    command.add_flag("--map", options.on_map,
                     "places are in the coordinates of the terrain file: metres, feet, or "
                     "longitude and latitude");
    command.add_option("-o,--output", options.table, "the table (default: standard output)")
        ->type_name("FILE.csv");
    command.add_option("--picture", options.picture, "a figure of the profile: PNG, PDF or SVG")
        ->type_name("FILE");
    constexpr double largest = 1e6;
    add_number(command, "--exaggeration", options.exaggeration, 0, largest,
               "vertical, of the picture (default: what its frame allows)");
    add_force(command, options.force);
    add_settings(command, options.settings,
                 "override a scene key, as grid.cell_size or bed.nodata (repeatable)");
    add_examples(
        command,
        {{"fumon run dem.asc -o out --set model.rain=30", "an hour of rain"},
         {"fumon profile out --from 1200,800 -o stream.csv --picture stream.png", ""},
         {"fumon profile dem.asc --picture stream.png", "the longest stream of a terrain"},
         {"fumon profile dem.asc --along 0,0 600,400 900,400 --picture line.png",
          "a line of your own"}},
        "A stream's way goes down over the water's surface, where there is water, else over the "
        "bed, to the edge of\nthe grid; hollows count as filled.");
}

struct GridPoint {
    double x = 0.0;
    double y = 0.0;
};

GridPoint parse_point(const std::string& text, const char* option) {
    GridPoint place;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, place.x);
    const bool comma = first.ec == std::errc{} && first.ptr != end && *first.ptr == ',';
    const auto second = comma ? std::from_chars(first.ptr + 1, end, place.y) : first;
    if (!comma || second.ec != std::errc{} || second.ptr != end || !std::isfinite(place.x) ||
        !std::isfinite(place.y))
        throw InputError(
            fmt::format("{} is \"{}\"; it takes X,Y, for example 1200,800", option, text));
    return place;
}

/// Where a place lies in cells from the south-west corner.
GridPoint in_cells(const ProfileOptions& options, const std::string& text, const char* option,
                   const Snapshot& snapshot) {
    const GridPoint given = parse_point(text, option);
    const WorldScale& scale = snapshot.scale;
    if (options.on_map && !scale.place)
        throw InputError(fmt::format(
            "--map: {} has no map coordinates; without this option, {} is in metres from "
            "the south-west corner",
            options.input, option));
    const GeoReference bed{0.0, 0.0, scale.dx, scale.dy};
    const GeoReference& place = options.on_map ? *scale.place : bed;
    const GridPoint found{(given.x - place.west) / place.dx, (given.y - place.south) / place.dy};
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    if (found.x >= 0.0 && found.y >= 0.0 && found.x <= nx && found.y <= ny) return found;
    const char* const unit = !scale.in_metres       ? "sites"
                             : !options.on_map      ? "m"
                             : scale.place->degrees ? "degrees"
                                                    : "of its unit";
    throw InputError(fmt::format(
        "{} {} lies outside the grid, which goes from {:.10g},{:.10g} to {:.10g},{:.10g} {}",
        option, text, place.west, place.south, place.west + place.dx * nx,
        place.south + place.dy * ny, unit));
}

/// Where the longest way down begins.
GridPoint main_stream_start(const FlowRouting& routing) {
    const std::int32_t head = main_stream_head(routing);
    if (head == FlowRouting::outlet) throw InputError("the terrain has no cell with data");
    const int nx = routing.level.nx();
    const int x = head % nx;
    const int y = head / nx;
    return {static_cast<double>(x), static_cast<double>(y)};
}

/// Bed and water along a way, metres (or sites and model heights).
struct Profile {
    std::vector<double> distance;
    std::vector<double> x;  ///< in the coordinates of the places
    std::vector<double> y;
    std::vector<double> bed;
    std::vector<double> level;
    std::vector<double> area;  ///< that drains through the place; of a stream
};

/// The level of the water, or of the bed where there is none.
Grid level_of(const Snapshot& snapshot, const Grid& bed) {
    Grid level = bed;
    if (const Grid* depth = field_of(snapshot.fields, "water_depth"))
        std::ranges::transform(bed.values(), depth->values(), level.values().begin(), std::plus{});
    return level;
}

/// Writes a place, of the grid's cells, into a profile.
void add_place(Profile& profile, const GeoReference& place, double x, double y) {
    profile.x.push_back(place.west + x * place.dx);
    profile.y.push_back(place.south + y * place.dy);
}

Profile stream_of(const ProfileOptions& options, const Snapshot& snapshot, const Grid& bed,
                  const Grid& level, const GeoReference& place) {
    const FlowRouting routing =
        route_flow(level, snapshot.nodata, snapshot.scale.dx, snapshot.scale.dy);
    const Grid area = drainage_area(routing);
    const GridPoint start = options.from.empty()
                                ? main_stream_start(routing)
                                : in_cells(options, options.from, "--from", snapshot);
    const StreamPath path =
        stream_path(routing, snapshot.nodata, std::min(static_cast<int>(start.x), bed.nx() - 1),
                    std::min(static_cast<int>(start.y), bed.ny() - 1));
    Profile profile;
    profile.distance = path.distance;
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        add_place(profile, place, path.x[i] + 0.5, path.y[i] + 0.5);
        profile.bed.push_back(bed(path.x[i], path.y[i]));
        profile.level.push_back(level(path.x[i], path.y[i]));
        profile.area.push_back(area(path.x[i], path.y[i]));
    }
    return profile;
}

Profile line_of(const ProfileOptions& options, const Snapshot& snapshot, const Grid& bed,
                const Grid& level, const GeoReference& place) {
    std::vector<std::array<double, 2>> corners;
    for (const std::string& text : options.along) {
        const GridPoint corner = in_cells(options, text, "--along", snapshot);
        if (!corners.empty() && corners.back() == std::array{corner.x, corner.y})
            throw InputError(fmt::format("--along has the point {} twice in a row", text));
        corners.push_back({corner.x, corner.y});
    }
    Profile profile;
    for (const PolylinePoint& at : sample_polyline(corners, snapshot.scale.dx, snapshot.scale.dy)) {
        profile.distance.push_back(at.distance);
        add_place(profile, place, at.x, at.y);
        profile.bed.push_back(value_between(bed, snapshot.nodata, at.x, at.y));
        profile.level.push_back(value_between(level, snapshot.nodata, at.x, at.y));
    }
    if (std::ranges::none_of(profile.bed, [](double height) { return std::isfinite(height); }))
        throw InputError("--along: no cell under the line has data");
    return profile;
}

Profile profile_of(const ProfileOptions& options, const Snapshot& snapshot) {
    const Grid bed = ground_of(snapshot);
    const Grid level = level_of(snapshot, bed);
    const GeoReference grid{0.0, 0.0, snapshot.scale.dx, snapshot.scale.dy};
    const bool on_map = options.on_map && snapshot.scale.place;
    const GeoReference& place = on_map ? *snapshot.scale.place : grid;
    return options.along.empty() ? stream_of(options, snapshot, bed, level, place)
                                 : line_of(options, snapshot, bed, level, place);
}

/// A number of a table; nothing where there is none.
std::string number_in(const char* form, double value) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : "";
}

std::string table_of(const Profile& profile, bool in_metres) {
    const std::string unit = in_metres ? "_m" : "";
    std::vector<std::string> header{"distance" + unit, "x",          "y",
                                    "level" + unit,    "bed" + unit, "depth" + unit};
    if (!profile.area.empty()) header.emplace_back(in_metres ? "area_m2" : "area_cells");
    std::string text = csv_line(header);
    for (std::size_t i = 0; i < profile.distance.size(); ++i) {
        std::vector<std::string> row{fmt::format("{:.10g}", profile.distance[i]),
                                     fmt::format("{:.12g}", profile.x[i]),
                                     fmt::format("{:.12g}", profile.y[i]),
                                     number_in("{:.10g}", profile.level[i]),
                                     number_in("{:.10g}", profile.bed[i]),
                                     number_in("{:.6g}", profile.level[i] - profile.bed[i])};
        if (!profile.area.empty()) row.push_back(fmt::format("{:.10g}", profile.area[i]));
        text += csv_line(row);
    }
    return text;
}

/// Values at even distances, as the panel takes them: the middles of `count` pieces.
std::vector<double> evenly(const Profile& profile, const std::vector<double>& values,
                           std::size_t count) {
    const double length = profile.distance.back();
    std::vector<double> even;
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = length * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        while (next + 1 < values.size() && profile.distance[next] < at) ++next;
        const double from = profile.distance[next - 1];
        const double share = (at - from) / (profile.distance[next] - from);
        even.push_back((1.0 - share) * values[next - 1] + share * values[next]);
    }
    return even;
}

std::string picture_of(const ProfileOptions& options, const Profile& profile, bool in_metres,
                       bool has_water, PageFormat format) {
    if (profile.distance.size() < 2)
        throw InputError(
            "the stream starts at the grid's edge and has no length, so there is no profile to "
            "draw");
    constexpr std::size_t most_samples = 2000;
    const std::size_t samples = std::min(most_samples, 4 * profile.distance.size());
    ProfilePicture picture;
    picture.lines.resize(1);
    picture.lines[0].bed = evenly(profile, profile.bed, samples);
    if (has_water) picture.lines[0].surface = evenly(profile, profile.level, samples);
    picture.length = profile.distance.back();
    picture.in_metres = in_metres;
    picture.along = "distance";
    picture.exaggeration = options.exaggeration;
    Page page;
    page.width = page_size("double").width;
    page.panel_aspect = 3.0;
    page.panels.emplace_back();
    page.panels[0].content = std::make_unique<ProfilePanel>(std::move(picture));
    constexpr double dots_per_inch = 200.0;
    return draw_page(page, format, dots_per_inch, own_text()).bytes;
}

PageFormat format_of(const std::string& file) {
    static constexpr std::array<std::string_view, 3> endings{".png", ".pdf", ".svg"};
    check_ending(file, "a picture", endings);
    const std::string ending = small_ending(file);
    if (ending == ".pdf") return PageFormat::pdf;
    return ending == ".svg" ? PageFormat::svg : PageFormat::png;
}

int perform(const ProfileOptions& options) {
    const std::string input = last_state_of(terrain_argument(options.input)).string();
    OutputClaims claims(options.force);
    claims.reads(input);
    PageFormat format = PageFormat::png;
    if (!options.picture.empty()) {
        format = format_of(options.picture);
        claims.writes(options.picture);
    }
    if (!options.table.empty() && options.table != standard_output) {
        check_ending(options.table, "a table", table_ending);
        claims.writes(options.table);
    }
    const Snapshot snapshot = read_snapshot(input, {}, options.settings);
    const Profile profile = profile_of(options, snapshot);
    const bool in_metres = snapshot.scale.in_metres;
    const std::string table = table_of(profile, in_metres);
    std::string picture;
    if (!options.picture.empty()) {
        const bool has_water = field_of(snapshot.fields, "water_depth") != nullptr;
        picture = picture_of(options, profile, in_metres, has_water, format);
    }
    if (options.table.empty() || options.table == standard_output) {
        std::fputs(table.c_str(), stdout);
    } else {
        write_file(options.table, table);
    }
    if (!options.picture.empty()) write_file(options.picture, picture);
    return 0;
}

}  // namespace

Command profile_command() {
    return make_command<ProfileOptions>(
        "profile", "the way of water from a place, or a line: level, bed and depth along it",
        declare, perform);
}

}  // namespace fumon
