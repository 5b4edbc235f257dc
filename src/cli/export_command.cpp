#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/tell.h"
#include "base/worker_pool.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "cli/snapshot_argument.h"
#include "files/atomic_file.h"
#include "files/netcdf/netcdf_record.h"
#include "files/terrain/terrain_format.h"
#include "mesh/glb.h"
#include "mesh/height_mesh.h"
#include "mesh/stl.h"
#include "mesh/vtk.h"
#include "outputs/output_claims.h"
#include "picture/png.h"
#include "run/drawing.h"
#include "run/frame_painter.h"
#include "run/inputs/scene_argument.h"
#include "run/still.h"
#include "scene/terrain_scene.h"

namespace fumon {

namespace {

/// What a bed may become. `terrain` names its format among those of terrain; empty: a surface.
struct ExportKind {
    std::string_view name;    ///< --as
    std::string_view ending;  ///< of a file's name, after which it is taken; the longest wins
    std::string_view terrain{};
};

constexpr std::array<ExportKind, 7> export_kinds{
    {{"vts", ".vts"},
     {"pvd", ".pvd"},
     {"glb", ".glb"},
     {"stl", ".stl"},
     {"cloud-optimized-geotiff", ".cog.tif", "cloud-optimized-geotiff"},
     {"geotiff", ".tif", "geotiff"},
     {"esri-ascii", ".asc", "esri-ascii"}}};

struct ExportOptions {
    std::string input;   ///< a run's folder, a fields.nc or a terrain file
    std::string output;  ///< a file, or "-"
    std::string as;      ///< the name of a kind; empty: by the file's ending
    std::string heights;
    double exaggeration = 1.0;
    double size = 150.0;  ///< mm, of the longer side of an STL
    double base = 4.0;    ///< mm, below its lowest point
    std::int64_t triangles = 500'000;
    bool force = false;
    WorkOptions work;
};

void declare(CLI::App& command, ExportOptions& options) {
    command
        .add_option("INPUT", options.input,
                    "a run's folder (its fields.nc, else its last bed), a fields.nc, or terrain")
        ->required();
    command
        .add_option(
            "-o,--output", options.output,
            "VTK for ParaView (.vts, or .pvd with a .vts for each record of fields.nc), GLB "
            "for slides (.glb), STL for printing (.stl), a grid of heights (.asc, .tif, .cog.tif); "
            "- is standard output")
        ->type_name("FILE")
        ->required();
    std::vector<std::string> names;
    names.reserve(export_kinds.size());
    for (const ExportKind& kind : export_kinds) names.emplace_back(kind.name);
    add_word(command, "--as", options.as, names,
             "what it becomes, where the name does not say (for standard output esri-ascii)");
    constexpr double largest = 1e6;
    add_number(command, "--exaggeration", options.exaggeration, 1e-6, largest,
               "vertical (default 1)");
    add_number(command, "--size", options.size, 1, largest,
               "millimetres of an STL's longer side (default 150)");
    add_number(command, "--base", options.base, 0.1, largest,
               "millimetres below its lowest point (default 4)");
    constexpr double most = 5e7;
    add_number(command, "--triangles", options.triangles, 2, most,
               "of the surface of a GLB or STL at most, else it gets coarser (default 500000)");
    add_heights(command, options.heights);
    add_force(command, options.force);
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon export dem.asc -o dem.stl --size 200 --exaggeration 2", "to be printed"},
         {"fumon export out/rain -o rain.pvd", "a run, for ParaView"},
         {"fumon export out/dunes -o bed.tif", "its last bed, for GIS"},
         {"fumon export out/dunes -o - | awk 'NR > 6' > bed.txt", "to a program"}},
        "A GLB has the colours of a picture from above: --set look.palette=… and all other "
        "looks change it.");
}

/// A surface as it is printed: its longer side `size` millimetres, standing on z = 0.
Mesh printed(const HeightMesh& surface, double size, double base) {
    Mesh top = surface.top;
    double longest = 0.0;
    MeshPoint low = top.points.front();
    MeshPoint high = low;
    for (const MeshPoint& point : top.points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
    }
    longest = std::max(high.x - low.x, high.y - low.y);
    const double scale = size / longest;
    for (MeshPoint& point : top.points) {
        point = {(point.x - low.x) * scale, (point.y - low.y) * scale,
                 (point.z - low.z) * scale + base};
    }
    return closed_solid(top, 0.0);
}

/// The bed from above, as far as it reaches and with nothing over it.
std::vector<std::uint8_t> texture_of(const ExportOptions& options, const std::string& input,
                                     const Snapshot& snapshot) {
    constexpr double longer_side = 2048.0;  // pixels
    Scene scene = terrain_scene(input, options.heights, options.work.settings);
    scene.view.overlays.clear();
    scene.view.camera = {};
    scene.view.camera.projection = Projection::map;
    scene.view.camera.margin = 0.0;
    scene.view.sun.haze = 0.0;
    const double width = snapshot.bed.nx() * snapshot.scale.dx;
    const double height = snapshot.bed.ny() * snapshot.scale.dy;
    const double pixels = longer_side / std::max(width, height);
    scene.view.image.width = std::max(16L, std::lround(width * pixels));
    scene.view.image.height = std::max(16L, std::lround(height * pixels));
    WorkerPool pool(options.work.threads, "fumon-render");
    const auto painter =
        make_frame_painter(scene, snapshot, options.work.backend, pool, PaintedFrames::one_picture);
    return encode_png(painter->paint(snapshot, {}), screen_dots_per_inch, own_text());
}

void tell_coarser(const HeightMesh& mesh) {
    if (mesh.cells_a_point == 1) return;
    tell(
        fmt::format("{} triangles: each point is the mean of {} x {} cells (--triangles allows "
                    "more)\n",
                    mesh.top.triangles.size(), mesh.cells_a_point, mesh.cells_a_point));
}

/// NAME_000000.vts … beside NAME.pvd.
std::filesystem::path moment_file(const std::string& output, std::size_t number) {
    std::filesystem::path file = output;
    const std::string name = fmt::format("{}_{:06}.vts", file.stem().string(), number);
    return file.replace_filename(name);
}

void write_series(const ExportOptions& options, const std::string& input, OutputClaims& claims) {
    const std::vector<FieldsMoment> moments = read_fields_moments(input);
    for (std::size_t n = 0; n < moments.size(); ++n) claims.writes(moment_file(options.output, n));
    const Snapshot outline = read_snapshot(input, options.heights, options.work.settings);
    std::vector<VtkMoment> written;
    for (std::size_t n = 0; n < moments.size(); ++n) {
        const std::filesystem::path file = moment_file(options.output, n);
        write_file(file, vts_file(read_fields_snapshot(input, moments[n].step, outline),
                                  options.exaggeration));
        written.push_back({moments[n].time, file.filename().string()});
    }
    write_file(options.output, pvd_file(written));
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
    throw InputError(fmt::format("{}: the name of what is exported ends in {}; or say it by --as",
                                 options.output, endings));
}

/// The files of a kind that is not a series: the first is FILE itself, others stand beside it.
std::vector<TerrainBytes> exported(const ExportOptions& options, const ExportKind& kind,
                                   const std::string& input) {
    const Snapshot snapshot = read_snapshot(input, options.heights, options.work.settings);
    std::vector<TerrainBytes> files;
    if (!kind.terrain.empty()) return bed_files(snapshot, std::array{std::string(kind.terrain)});
    if (kind.name == "vts") {
        files.push_back({".vts", vts_file(snapshot, options.exaggeration)});
        return files;
    }
    const HeightMesh mesh =
        height_mesh(snapshot, options.exaggeration, static_cast<std::size_t>(options.triangles));
    tell_coarser(mesh);
    const bool prints = kind.name == "stl";
    files.push_back(
        {std::string(kind.ending), prints ? stl_file(printed(mesh, options.size, options.base))
                                          : glb_file(mesh, texture_of(options, input, snapshot))});
    return files;
}

/// FILE without the ending of its kind, where it has it.
std::string stem_of(const ExportOptions& options, const ExportKind& kind) {
    const std::string& file = options.output;
    const bool has_ending = in_small_letters(file).ends_with(kind.ending);
    return has_ending ? file.substr(0, file.size() - kind.ending.size()) : file;
}

void check_kind(const ExportOptions& options, const ExportKind& kind) {
    if (to_standard_output(options)) {
        if (kind.name == "pvd") throw InputError("-o -: a .pvd names its .vts files; name a file");
        if (kind.name != "esri-ascii") refuse_terminal("what is exported is no text", "bed.tif");
        return;
    }
    if (kind.terrain.empty()) return;
    const TerrainFormat& format = *find_written_format(kind.terrain);
    if (!format.lacks.empty()) {
        throw InputError(fmt::format("{}: {} needs GDAL, and this fumon was built without it; {}",
                                     options.output, format.title, format.lacks));
    }
}

int perform(const ExportOptions& options) {
    const ExportKind& kind = kind_of(options);
    check_kind(options, kind);
    const std::string input = last_state_of(terrain_argument(options.input)).string();
    OutputClaims claims(options.force);
    claims.reads(input);
    if (kind.name == "glb") prepare_drawing(options.work);
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
    return make_command<ExportOptions>(
        "export",
        "a bed, or a run's fields, for ParaView (VTK), slides (GLB), printers (STL) and GIS",
        declare, perform);
}

}  // namespace fumon
