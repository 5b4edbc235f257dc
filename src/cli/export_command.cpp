#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "cli/snapshot_argument.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_record.h"
#include "files/terrain/terrain_format.h"
#include "foreign/open_run.h"
#include "mesh/drawn/surface_file.h"
#include "mesh/height_mesh.h"
#include "mesh/vtk.h"
#include "mesh/vtk_section.h"
#include "outputs/output_claims.h"
#include "rasters/raster_files.h"
#include "run/drawing.h"
#include "run/inputs/scene_argument.h"
#include "run/still.h"
#include "scene/initial_bed.h"
#include "scene/terrain_scene.h"
#include "web/page_run.h"
#include "web/run_page.h"

namespace fumon {

namespace {

/// What a bed may become. `terrain` names its format among those of terrain; empty: a surface.
struct ExportKind {
    std::string_view name;    ///< --as
    std::string_view ending;  ///< of a file's name, after which it is taken; the longest wins
    std::string_view terrain{};
};

constexpr std::array<ExportKind, 11> export_kinds{
    {{"vts", ".vts"},
     {"pvd", ".pvd"},
     {"glb", ".glb"},
     {"stl", ".stl"},
     {"ply", ".ply"},
     {"obj", ".obj"},
     {"html", ".html"},
     {"netcdf", ".nc"},
     {"cloud-optimized-geotiff", ".cog.tif", "cloud-optimized-geotiff"},
     {"geotiff", ".tif", "geotiff"},
     {"esri-ascii", ".asc", "esri-ascii"}}};

constexpr std::int64_t last_record = -1;
constexpr double as_it_is = 0.0;

struct ExportOptions {
    std::string input;   ///< a run's folder, a fields.nc or a terrain file
    std::string output;  ///< a file, or "-"
    std::string as;      ///< the name of a kind; empty: by the file's ending
    std::string field;   ///< of a grid; empty: the heights
    std::string heights;
    double exaggeration = as_it_is;
    double size = 150.0;  ///< mm, of the longer side of an STL
    double base = 4.0;    ///< mm, below its lowest point
    std::int64_t triangles = 500'000;
    std::int64_t step = last_record;
    std::int64_t beds = PageOptions::usual_beds;
    bool force = false;
    WorkOptions work;
};

double vertical(const ExportOptions& options) {
    return options.exaggeration == as_it_is ? 1.0 : options.exaggeration;
}

void declare(CLI::App& command, ExportOptions& options) {
    command
        .add_option("INPUT", options.input,
                    "a run's folder (its fields.nc, else its last bed), a fields.nc, or terrain")
        ->required();
    command
        .add_option(
            "-o,--output", options.output,
            "VTK for ParaView (.vts, or .pvd with a .vts for each record of fields.nc), GLB "
            "for slides (.glb), a page to turn in any browser (.html), STL for printing (.stl), a "
            "coloured mesh (.ply, .obj), a grid of "
            "heights or of --field (.asc, .tif, .cog.tif, .nc); - is standard output")
        ->type_name("FILE")
        ->required();
    std::vector<std::string> names;
    names.reserve(export_kinds.size());
    for (const ExportKind& kind : export_kinds) names.emplace_back(kind.name);
    add_word(command, "--as", options.as, names,
             "what it becomes, where the name does not say (for standard output esri-ascii)");
    command
        .add_option("--field", options.field,
                    "what a grid holds (.tif, .cog.tif, .asc, .nc): a name of the list below; "
                    "default: height, and in .nc all fields of the input")
        ->type_name("NAME")
        ->check(CLI::Validator([](std::string&) { return std::string(); }, "",
                               words_as_name(raster_names())));
    constexpr double largest = 1e6;
    add_number(command, "--exaggeration", options.exaggeration, 1e-6, largest,
               "vertical, also of a hillshade (default 1; of .html that of pictures)");
    add_number(command, "--size", options.size, 1, largest,
               "millimetres of an STL's longer side (default 150)");
    add_number(command, "--base", options.base, 0.1, largest,
               "millimetres below its lowest point (default 4)");
    constexpr double most = 5e7;
    constexpr double most_page_beds = 400;
    add_number(
        command, "--triangles", options.triangles, 2, most,
        "of the surface of a GLB, HTML, STL, PLY or OBJ at most, else it gets coarser (default "
        "500000)");
    add_number(command, "--beds", options.beds, 1, most_page_beds,
               "of a run in .html at most, evenly among those that it stored (default 100)");
    constexpr double latest = 9e15;
    add_number(command, "--step", options.step, 0, latest,
               "of a run's folder or fields.nc: the record of this step (default: the last)");
    add_heights(command, options.heights);
    add_force(command, options.force);
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon export dem.asc -o dem.stl --size 200 --exaggeration 2", "to be printed"},
         {"fumon export out/rain -o rain.pvd", "a run, for ParaView"},
         {"fumon export out/dunes -o dunes.html", "a run to turn and play, for anybody's browser"},
         {"fumon export out/dunes -o bed.tif", "its last bed, for GIS"},
         {"fumon export dem.tif -o slope.tif --field slope", "a grid of slopes"},
         {"fumon export out/rain -o depth.tif --field water-depth", "of a run's last record"},
         {"fumon export out/rain -o before.tif --step 0", "of its first"},
         {"fumon export out/dunes -o - | awk 'NR > 6' > bed.txt", "to a program"}},
        raster_help() +
            "\nHTML, GLB, PLY and OBJ have the colours of a picture from above: --set "
            "look.palette=… and all other looks change it.");
}

void report_coarser(const HeightMesh& mesh) {
    if (mesh.cells_per_point == 1) return;
    remark(
        fmt::format("{} triangles: each point is the mean of {} x {} cells (--triangles allows "
                    "more)\n",
                    mesh.top.triangles.size(), mesh.cells_per_point, mesh.cells_per_point));
}

/// NAME_000000.vts … beside NAME.pvd; NAME_air_000000.vts and NAME_paths_000000.vtp.
std::filesystem::path moment_file(const std::string& output, std::size_t number,
                                  const char* part = "", const char* ending = ".vts") {
    std::filesystem::path file = output;
    const std::string name =
        fmt::format("{}{}_{:06}{}", file.stem().string(), part, number, ending);
    return file.replace_filename(name);
}

void write_series(const ExportOptions& options, const std::string& input, OutputClaims& claims) {
    if (!is_netcdf(start_of_input_file(input, netcdf_signature_length))) {
        throw InputError(fmt::format(
            "{}: has a single record, and a .pvd is a time series; export .vts, or name a "
            "run's folder or fields.nc",
            input));
    }
    const std::vector<FieldsMoment> moments = read_fields_moments(input);
    const Snapshot outline = read_snapshot(input, options.heights, options.work.settings);
    const bool has_paths = outline.section && !outline.section->paths.empty();
    const auto air_file = [&](std::size_t n) { return moment_file(options.output, n, "_air"); };
    const auto paths_file = [&](std::size_t n) {
        return moment_file(options.output, n, "_paths", ".vtp");
    };
    for (std::size_t n = 0; n < moments.size(); ++n) {
        claims.writes(moment_file(options.output, n));
        if (outline.section) claims.writes(air_file(n));
        if (has_paths) claims.writes(paths_file(n));
    }
    std::vector<VtkMoment> written;
    for (std::size_t n = 0; n < moments.size(); ++n) {
        const Snapshot snapshot = read_fields_snapshot(input, moments[n].step, outline);
        const double time = moments[n].time;
        written.push_back({time, {}});
        const auto write = [&](const std::filesystem::path& file, const std::string& bytes) {
            write_file(file, bytes);
            written.back().files.push_back(file.filename().string());
        };
        write(moment_file(options.output, n), vts_file(snapshot, vertical(options)));
        if (!snapshot.section) continue;
        write(air_file(n), vts_section_file(*snapshot.section, time, vertical(options)));
        if (has_paths)
            write(paths_file(n), vtp_paths_file(*snapshot.section, time, vertical(options)));
    }
    write_file(options.output, pvd_file(written));
    remark(fmt::format("{}: {} record{} of {}\n", options.output, written.size(),
                       written.size() == 1 ? "" : "s", input));
}

bool to_standard_output(const ExportOptions& options) {
    return options.output == standard_output;
}

std::string in_small_letters(std::string text) {
    for (char& letter : text) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return text;
}

const ExportKind& kind_of(const ExportOptions& options) {
    std::string asked = options.as;
    if (asked.empty() && to_standard_output(options)) asked = "esri-ascii";
    const std::string file = in_small_letters(options.output);
    std::string endings;
    for (const ExportKind& kind : export_kinds) {
        const bool is_meant = asked.empty() ? file.ends_with(kind.ending) : kind.name == asked;
        if (is_meant) return kind;
        endings += fmt::format("{}{}", endings.empty() ? "" : ", ", kind.ending);
    }
    throw InputError(
        fmt::format("{}: the output's name must end in {}; or give the format with --as",
                    options.output, endings));
}

std::string mesh_file(const ExportOptions& options, const ExportKind& kind, const HeightMesh& mesh,
                      const std::string& input, const Snapshot& snapshot) {
    if (kind.name == "stl") return printed_file(mesh, options.size, options.base);
    std::string note;
    const Image picture = picture_from_above(
        terrain_scene(input, options.heights, options.work.settings), snapshot, options.work, note);
    if (!note.empty()) remark(note + "\n");
    return coloured_file(kind.name, mesh, picture);
}

bool is_coloured(const ExportKind& kind) {
    return kind.name == "glb" || kind.name == "ply" || kind.name == "obj";
}

/// The sun stands as settings say; else as in other programs, and not as in pictures.
RasterRequest raster_request(const ExportOptions& options, const std::string& input) {
    const Scene scene = terrain_scene(input, options.heights, options.work.settings);
    RasterRequest request{input, options.field};
    HillLight& light = request.light;
    if (scene.set_on_command_line("sun.azimuth")) light.azimuth = scene.view.sun.azimuth;
    if (scene.set_on_command_line("sun.elevation")) light.elevation = scene.view.sun.elevation;
    light.exaggeration = vertical(options);
    return request;
}

/// What the input holds at the asked step. Throws InputError where it has no record of that step.
Snapshot snapshot_of(const ExportOptions& options, const std::string& input) {
    if (options.step != last_record) {
        if (std::optional<Snapshot> state = foreign_state(input, options.step))
            return *std::move(state);
    }
    const bool chosen = options.step != last_record && is_fields_file(input);
    Snapshot snapshot = read_snapshot(input, options.heights, options.work.settings, !chosen);
    if (!chosen) return snapshot;
    return read_fields_snapshot(input, options.step, std::move(snapshot));
}

/// The file that holds the asked state of a run's folder, or the input itself. Throws InputError
/// where it has no such state.
std::string state_file(const ExportOptions& options) {
    const std::string input = terrain_argument(options.input);
    if (options.step == last_record) return last_state_of(input).string();
    std::string file = state_of_step(input, options.step).string();
    if (std::error_code fault; std::filesystem::is_directory(input, fault)) return file;
    if (is_foreign_run(file) || is_fields_file(file)) return file;
    throw InputError(fmt::format(
        "--step {}: {} has a single record; --step takes a run's folder, its fields.nc, or the "
        "NetCDF of another model",
        options.step, input));
}

/// A run, or a bed, as one page for browsers.
void write_page(const ExportOptions& options, OutputClaims& claims) {
    const std::optional<std::int64_t> step =
        options.step == last_record ? std::nullopt : std::optional(options.step);
    std::optional<PageRun> run;
    if (options.heights.empty())
        run = stored_page_run(options.input, options.work.threads, options.work.settings, step);
    if (!run) {
        const std::string input = state_file(options);
        std::string note;
        run = single_page_run(input, terrain_scene(input, options.heights, options.work.settings),
                              snapshot_of(options, input), note);
        if (!note.empty()) remark(note + "\n");
    }
    claims.reads(run->files);
    claims.writes(options.output);
    PageOptions page;
    page.beds = static_cast<std::size_t>(options.beds);
    page.exaggeration = options.exaggeration;
    page.most_triangles = static_cast<std::size_t>(options.triangles);
    write_file(options.output, page_file(*run, page, options.work));
}

/// The files of a kind that is not a series: the first is FILE itself, others stand beside it.
std::vector<TerrainBytes> exported(const ExportOptions& options, const ExportKind& kind,
                                   const std::string& input) {
    const Snapshot snapshot = snapshot_of(options, input);
    if (!options.field.empty())
        return raster_files(raster_request(options, input), snapshot, kind.terrain);
    std::vector<TerrainBytes> files;
    if (!kind.terrain.empty()) return bed_files(snapshot, std::array{std::string(kind.terrain)});
    if (kind.name == "vts") {
        files.push_back({".vts", vts_file(snapshot, vertical(options))});
        return files;
    }
    const HeightMesh mesh =
        height_mesh(snapshot, vertical(options), static_cast<std::size_t>(options.triangles));
    report_coarser(mesh);
    files.push_back({std::string(kind.ending), mesh_file(options, kind, mesh, input, snapshot)});
    return files;
}

/// FILE without the ending of its kind, where it has it.
std::string stem_of(const ExportOptions& options, const ExportKind& kind) {
    const std::string& file = options.output;
    const bool has_ending = in_small_letters(file).ends_with(kind.ending);
    return has_ending ? file.substr(0, file.size() - kind.ending.size()) : file;
}

void check_kind(const ExportOptions& options, const ExportKind& kind) {
    if (options.step != last_record && kind.name == "pvd")
        throw InputError("--step: a .pvd holds all records; name a .vts for one of them");
    if (!options.field.empty() && kind.terrain.empty() && kind.name != "netcdf") {
        throw InputError(
            fmt::format("--field {}: a field is written as a grid: .tif, .cog.tif, .asc or .nc, "
                        "not as {}",
                        options.field, kind.name));
    }
    if (to_standard_output(options)) {
        if (kind.name == "pvd") throw InputError("-o -: a .pvd names its .vts files; name a file");
        if (kind.name == "netcdf") throw InputError("-o -: a NetCDF file needs a name");
        if (kind.name == "html") throw InputError("-o -: a page needs a name; name a file");
        if (kind.name != "esri-ascii") refuse_terminal("the exported file is binary", "bed.tif");
        return;
    }
    if (kind.terrain.empty()) return;
    const TerrainFormat& format = *find_written_format(kind.terrain);
    if (const std::string missing = format.missing(); !missing.empty())
        throw InputError(fmt::format("{}: {} {}", options.output, format.title, missing));
}

int perform(const ExportOptions& options) {
    const ExportKind& kind = kind_of(options);
    check_kind(options, kind);
    OutputClaims claims(options.force);
    if (kind.name == "html") {
        prepare_drawing(options.work);
        write_page(options, claims);
        return 0;
    }
    const std::string input = state_file(options);
    claims.reads(input);
    if (is_coloured(kind)) prepare_drawing(options.work);
    if (to_standard_output(options)) {
        const std::string bytes = exported(options, kind, input).front().bytes;
        std::fwrite(bytes.data(), 1, bytes.size(), stdout);  // looked at when the program ends
        return 0;
    }
    claims.writes(options.output);
    if (kind.name == "pvd") {
        write_series(options, input, claims);
        return 0;
    }
    if (kind.name == "netcdf") {
        write_raster_netcdf(raster_request(options, input), snapshot_of(options, input),
                            options.output);
        return 0;
    }
    const std::string stem = stem_of(options, kind);
    const std::vector<TerrainBytes> files = exported(options, kind, input);
    for (std::size_t n = 1; n < files.size(); ++n) claims.writes(stem + files[n].ending);
    for (std::size_t n = 1; n < files.size(); ++n)
        write_file(stem + files[n].ending, files[n].bytes);
    write_file(options.output, files.front().bytes);
    return 0;
}

}  // namespace

Command export_command() {
    return make_command<ExportOptions>("export",
                                       "a bed, or a run's fields, for ParaView (VTK), slides "
                                       "(GLB), browsers (HTML), printers (STL), meshes (PLY, OBJ) "
                                       "and GIS (heights, slope, drainage …)",
                                       declare, perform);
}

}  // namespace fumon
