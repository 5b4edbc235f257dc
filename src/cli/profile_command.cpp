#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
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
#include "measure/bed/stream_path.h"
#include "outputs/output_claims.h"
#include "picture/png.h"

namespace fumon {

namespace {

struct ProfileOptions {
    std::string input;        ///< a run's folder, a fields.nc or a terrain file
    std::string from;         ///< "x,y"
    bool on_map = false;      ///< in the file's coordinates
    std::string table;        ///< a CSV; empty: standard output
    std::string picture;      ///< a PNG, PDF or SVG; empty: none
    double exaggeration = 0;  ///< 0: as large as the frame allows
    bool force = false;
    std::vector<std::string> settings;
};

void declare(CLI::App& command, ProfileOptions& options) {
    command
        .add_option("RUN", options.input,
                    "a run's folder (its fields.nc, else its last bed), a fields.nc, or terrain")
        ->required();
    command
        .add_option("--from", options.from,
                    "where the stream begins: metres east and north of the bed's south-west corner")
        ->type_name("X,Y")
        ->required();
    command.add_flag("--map", options.on_map,
                     "--from is in the coordinates of the terrain file: metres, or longitude and "
                     "latitude");
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
    add_examples(command,
                 {{"fumon run dem.asc -o out --set model.rain=30", "an hour of rain"},
                  {"fumon profile out --from 1200,800 -o stream.csv --picture stream.png", ""}},
                 "The way goes down over the water's surface, where there is water, else over the "
                 "bed, to the edge of\nthe grid; hollows count as filled.");
}

struct Place {
    double x = 0.0;
    double y = 0.0;
};

Place parse_place(const std::string& text) {
    Place place;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, place.x);
    const bool comma = first.ec == std::errc{} && first.ptr != end && *first.ptr == ',';
    const auto second = comma ? std::from_chars(first.ptr + 1, end, place.y) : first;
    if (!comma || second.ec != std::errc{} || second.ptr != end || !std::isfinite(place.x) ||
        !std::isfinite(place.y))
        throw InputError(fmt::format("--from is \"{}\"; it takes X,Y, for example 1200,800", text));
    return place;
}

/// Where a place lies in cells from the south-west corner.
Place in_cells(const ProfileOptions& options, const Snapshot& snapshot) {
    const Place given = parse_place(options.from);
    const WorldScale& scale = snapshot.scale;
    if (!options.on_map) return {given.x / scale.dx, given.y / scale.dy};
    if (!scale.place)
        throw InputError(fmt::format(
            "--map: {} lies nowhere on a map; leave the option out, and --from is in metres from "
            "the south-west corner",
            options.input));
    return {(given.x - scale.place->west) / scale.place->dx,
            (given.y - scale.place->south) / scale.place->dy};
}

/// Bed and water along a way, metres (or sites and model heights).
struct Profile {
    std::vector<double> distance;
    std::vector<double> x;  ///< in the coordinates of --from
    std::vector<double> y;
    std::vector<double> bed;
    std::vector<double> level;
};

Profile profile_of(const ProfileOptions& options, const Snapshot& snapshot) {
    const WorldScale& scale = snapshot.scale;
    const double slope = number_of(snapshot, "mean_slope").value_or(0.0);
    const double slope_x = number_of(snapshot, "mean_slope_x").value_or(0.0);
    const Grid* depth = field_of(snapshot.fields, "water_depth");
    Grid bed = snapshot.bed;
    Grid level = snapshot.bed;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double plane = slope * scale.dy * y - slope_x * scale.dx * x;
            bed(x, y) = bed(x, y) * scale.height_unit + plane;
            level(x, y) = bed(x, y) + (depth == nullptr ? 0.0 : (*depth)(x, y));
        }
    }
    const Place start = in_cells(options, snapshot);
    const bool inside =
        start.x >= 0.0 && start.y >= 0.0 && start.x < bed.nx() && start.y < bed.ny();
    if (!inside) {
        throw InputError(fmt::format(
            "--from {} lies outside the grid, which is {:.6g} by {:.6g} {}", options.from,
            scale.dx * bed.nx(), scale.dy * bed.ny(), scale.in_metres ? "m" : "sites"));
    }
    const StreamPath path = stream_path(level, snapshot.nodata, scale.dx, scale.dy,
                                        static_cast<int>(start.x), static_cast<int>(start.y));
    Profile profile;
    profile.distance = path.distance;
    const GeoReference grid{0.0, 0.0, scale.dx, scale.dy};
    const GeoReference& place = options.on_map ? *scale.place : grid;
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        profile.x.push_back(place.west + (path.x[i] + 0.5) * place.dx);
        profile.y.push_back(place.south + (path.y[i] + 0.5) * place.dy);
        profile.bed.push_back(bed(path.x[i], path.y[i]));
        profile.level.push_back(level(path.x[i], path.y[i]));
    }
    return profile;
}

std::string table_of(const Profile& profile, bool in_metres) {
    const std::string unit = in_metres ? "_m" : "";
    std::string text =
        csv_line({"distance" + unit, "x", "y", "level" + unit, "bed" + unit, "depth" + unit});
    for (std::size_t i = 0; i < profile.distance.size(); ++i) {
        text += csv_line(
            {fmt::format("{:.10g}", profile.distance[i]), fmt::format("{:.12g}", profile.x[i]),
             fmt::format("{:.12g}", profile.y[i]), fmt::format("{:.10g}", profile.level[i]),
             fmt::format("{:.10g}", profile.bed[i]),
             fmt::format("{:.6g}", profile.level[i] - profile.bed[i])});
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
            "the stream begins where it ends, at the edge; there is no profile to draw");
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
    const std::string input = last_state_of(options.input).string();
    OutputClaims claims(options.force);
    claims.reads(input);
    PageFormat format = PageFormat::png;
    if (!options.picture.empty()) {
        format = format_of(options.picture);
        claims.writes(options.picture);
    }
    if (!options.table.empty()) {
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
    if (options.table.empty()) {
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
        "profile", "the way of water from a place: level, bed and depth along it", declare,
        perform);
}

}  // namespace fumon
