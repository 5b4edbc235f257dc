#include "python/projections.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "python/module.h"
#include "render/colour/palette.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"
#include "scene/view/palette_names.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

std::array<double, 3> array_of(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

/// The camera of a picture and the block that it shows.
struct Shown {
    Block block;
    Camera camera;
};

Shown shown_in(const Scene& scene, const Snapshot& first, const Snapshot& snapshot) {
    const View& view = scene.view;
    const Block framed = framed_block(view, first);
    Shown shown;
    shown.block = block_of_frame(framed, view.look, first, snapshot);
    shown.camera = above_ground(camera_at_step(view, framed, snapshot.step, scene.run.steps),
                                shown.block, snapshot);
    return shown;
}

py::object place_of(const WorldScale& scale) {
    if (!scale.in_metres || !scale.place) return py::none();
    const GeoReference& place = *scale.place;
    return py::make_tuple(place.west, place.south, place.dx / scale.dx, place.dy / scale.dy,
                          place.degrees, place.crs);
}

py::array_t<std::uint8_t> palette_array(const std::string& name) {
    const Palette palette = read_palette(name);
    py::array_t<std::uint8_t> colours({static_cast<py::ssize_t>(palette.size()), py::ssize_t{3}});
    std::uint8_t* to = colours.mutable_data();
    for (const auto& colour : palette) to = std::copy(colour.begin(), colour.end(), to);
    return colours;
}

}  // namespace

py::dict projection_of(const Scene& scene, const Snapshot& first, const Snapshot& snapshot) {
    const View& view = scene.view;
    if (view.look.mode == ViewMode::figure && first.section)
        throw InputError("the flat figure of a section shows no positions on the ground");
    const std::optional<Snapshot> coarse_first = shown_snapshot(first, view);
    const std::optional<Snapshot> coarse = shown_snapshot(snapshot, view);
    const Snapshot& framing = coarse_first ? *coarse_first : first;
    const auto [block, camera] = shown_in(scene, framing, coarse ? *coarse : snapshot);
    py::dict result;
    result["is_map"] = view.camera.projection == Projection::map;
    result["pixels"] = py::make_tuple(view.image.width, view.image.height);
    result["map_pixels"] = map_rectangle(view, framing);
    result["perspective"] = camera.perspective;
    result["eye"] = array_of(camera.eye);
    result["axes"] = std::array<std::array<double, 3>, 3>{
        array_of(camera.right), array_of(camera.up), array_of(camera.forward)};
    result["half"] = std::array<double, 2>{camera.half.x, camera.half.y};
    result["side"] = block.side;
    result["width"] = std::array<double, 2>{block.width_x, block.width_y};
    result["reference"] = block.reference;
    result["height_scale"] = block.height_scale;
    result["exaggeration"] = block.exaggeration;
    result["in_metres"] = first.scale.in_metres;
    result["extent"] =
        std::array<double, 2>{first.bed.nx() * (first.scale.in_metres ? first.scale.dx : 1.0),
                              first.bed.ny() * (first.scale.in_metres ? first.scale.dy : 1.0)};
    result["height_unit"] = first.scale.in_metres ? first.scale.height_unit : 1.0;
    result["place"] = place_of(first.scale);
    return result;
}

void define_projections(py::module_& core) {
    core.def("palette", &palette_array, py::arg("name"));
    core.def("palette_names", &palette_names);
}

}  // namespace fumon::python
