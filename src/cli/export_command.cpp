#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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
#include "mesh/glb.h"
#include "mesh/height_mesh.h"
#include "mesh/stl.h"
#include "mesh/vtk.h"
#include "outputs/output_claims.h"
#include "picture/png.h"
#include "run/drawing.h"
#include "run/frame_painter.h"
#include "scene/terrain_scene.h"

namespace fumon {

namespace {

struct ExportOptions {
    std::string input;  ///< a run's folder, a fields.nc or a terrain file
    std::string output;
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
            "for slides (.glb), STL for printing (.stl)")
        ->type_name("FILE")
        ->required();
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
         {"fumon export out/rain -o rain.pvd", "a run, for ParaView"}},
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
    const auto painter = make_frame_painter(scene, snapshot, options.work.backend, pool);
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

int perform(const ExportOptions& options) {
    static constexpr std::array<std::string_view, 4> endings{".vts", ".pvd", ".glb", ".stl"};
    check_ending(options.output, "a surface", endings);
    const std::string ending = small_ending(options.output);
    const std::string input = last_state_of(options.input).string();
    OutputClaims claims(options.force);
    claims.reads(input);
    claims.writes(options.output);
    if (ending == ".glb") prepare_drawing(options.work);
    if (ending == ".pvd") {
        write_series(options, input, claims);
        return 0;
    }
    const Snapshot snapshot = read_snapshot(input, options.heights, options.work.settings);
    if (ending == ".vts") {
        write_file(options.output, vts_file(snapshot, options.exaggeration));
        return 0;
    }
    const HeightMesh mesh =
        height_mesh(snapshot, options.exaggeration, static_cast<std::size_t>(options.triangles));
    tell_coarser(mesh);
    if (ending == ".stl") {
        write_file(options.output, stl_file(printed(mesh, options.size, options.base)));
    } else {
        write_file(options.output, glb_file(mesh, texture_of(options, input, snapshot)));
    }
    return 0;
}

}  // namespace

Command export_command() {
    return make_command<ExportOptions>(
        "export", "a bed, or a run's fields, for ParaView (VTK), slides (GLB) and printers (STL)",
        declare, perform);
}

}  // namespace fumon
