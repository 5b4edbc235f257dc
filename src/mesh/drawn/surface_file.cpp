#include "mesh/drawn/surface_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/worker_pool.h"
#include "drape/lay_drape.h"
#include "drape/lay_layers.h"
#include "mesh/coloured_mesh.h"
#include "mesh/glb.h"
#include "mesh/stl.h"
#include "picture/png.h"
#include "run/frame_painter.h"
#include "scene/initial_bed.h"

namespace fumon {

namespace {

/// Of each point of a surface, in a picture from above.
std::vector<PointColour> colours_of(const HeightMesh& mesh, const Image& picture) {
    std::vector<PointColour> colours;
    colours.reserve(mesh.places.size());
    const auto pixel = [](double place, int pixels) {
        return std::clamp(static_cast<int>(place * pixels), 0, pixels - 1);
    };
    for (const auto& [east, north] : mesh.places) {
        const std::uint8_t* rgb = picture.row(pixel(1.0 - north, picture.height)) +
                                  3 * static_cast<std::size_t>(pixel(east, picture.width));
        colours.push_back({rgb[0], rgb[1], rgb[2]});
    }
    return colours;
}

}  // namespace

Image picture_from_above(Scene scene, const Snapshot& snapshot, const WorkOptions& work,
                         std::string& note) {
    constexpr double longer_side = 2048.0;  // pixels
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
    InitialBed drawn;
    drawn.bed = snapshot.bed;
    drawn.scale = snapshot.scale;
    lay_drape(scene, drawn);
    lay_layers(scene, drawn);
    note = std::move(drawn.note);
    WorkerPool pool(work.threads, "fumon-render");
    return make_frame_painter(scene, snapshot, work.backend, pool, PaintedContent::one_picture)
        ->paint(snapshot, {});
}

std::string printed_file(const HeightMesh& surface, double size, double base) {
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
    return stl_file(closed_solid(top, 0.0));
}

std::string coloured_file(std::string_view kind, const HeightMesh& mesh, const Image& picture) {
    if (kind == "glb") return glb_file(mesh, encode_png(picture, screen_dots_per_inch, own_text()));
    const std::vector<PointColour> colours = colours_of(mesh, picture);
    return kind == "ply" ? ply_file(mesh.top, colours) : obj_file(mesh.top, colours);
}

}  // namespace fumon
