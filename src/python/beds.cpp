#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/snapshots/ground_range.h"
#include "drape/lay_layers.h"
#include "drape/placed_drape.h"
#include "files/terrain/geographic.h"
#include "files/terrain/wanted_unit.h"
#include "files/unit_conversion.h"
#include "measure/raster/raster_quantity.h"
#include "measure/suite.h"
#include "python/arrays.h"
#include "python/drawer.h"
#include "python/geo_references.h"
#include "python/module.h"
#include "python/scene_value.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

using CellSize = std::optional<std::pair<double, double>>;

WorldScale scale_of(const CellSize& cell_size) {
    WorldScale scale;
    if (!cell_size) return scale;
    scale.dx = cell_size->first;
    scale.dy = cell_size->second;
    scale.in_metres = true;
    return scale;
}

struct Bed {
    Grid heights;
    Mask nodata;
};

Bed bed_of(const GridArray& heights, const std::optional<MaskArray>& nodata) {
    Bed bed{grid_of(heights), nodata ? mask_of(*nodata) : Mask()};
    if (!bed.nodata.empty() &&
        (bed.nodata.nx() != bed.heights.nx() || bed.nodata.ny() != bed.heights.ny()))
        throw InputError("the mask differs in shape from the heights");
    for (std::size_t cell = 0; cell < bed.nodata.size(); ++cell) {
        if (bed.nodata.values()[cell] != 0) bed.heights.values()[cell] = 0.0;
    }
    return bed;
}

void check_heights(const Snapshot& snapshot) {
    if (const std::string fault = beyond_ground(snapshot); !fault.empty()) throw InputError(fault);
}

/// Draws beds that Python brings, framed by the first of them, as terrain files are drawn.
class BedPainter {
  public:
    BedPainter(Scene scene, Bed first, const CellSize& cell_size,
               const std::optional<GeoReferenceTuple>& place, std::optional<Image> drape) {
        InitialBed initial;
        initial.bed = std::move(first.heights);
        initial.nodata = std::move(first.nodata);
        initial.scale = scale_of(cell_size);
        const bool is_laid_over = !scene.view.look.drape.empty() || !scene.view.layers.empty();
        if (place && is_laid_over) initial.scale.place = geo_reference_of(*place);
        PreparedRun run = prepare_run(prepare_scene(std::move(scene), std::move(initial)), 1);
        if (drape) {
            run.scene.view.drape = std::make_shared<const Drape>(fitted_drape(*std::move(drape)));
            lay_layers(run.scene, run.initial);  // whose areas lie over it
        }
        drawer_ = std::make_unique<Drawer>(run.scene, run.initial.inputs,
                                           std::make_shared<const Snapshot>(run.model->snapshot()));
    }

    [[nodiscard]] Drawing draw(std::optional<Bed> bed) const {
        if (!bed) return drawer_->draw(drawer_->first(), {});
        const Snapshot& first = *drawer_->first();
        if (bed->heights.nx() != first.bed.nx() || bed->heights.ny() != first.bed.ny())
            throw InputError("the heights differ in shape from the first ones");
        Snapshot snapshot = first;
        snapshot.bed = std::move(bed->heights);
        snapshot.nodata = std::move(bed->nodata);
        check_heights(snapshot);
        return drawer_->draw(std::make_shared<const Snapshot>(std::move(snapshot)), {});
    }

    [[nodiscard]] LayersDrawing draw_layers() const {
        return drawer_->draw_layers(drawer_->first());
    }

  private:
    std::unique_ptr<Drawer> drawer_;
};

std::vector<std::tuple<std::string, double, std::string, std::string>> measures_of_bed(
    Bed bed, const CellSize& cell_size, bool periodic, double channel_area) {
    Snapshot snapshot;
    snapshot.time_unit = "steps";
    snapshot.bed = std::move(bed.heights);
    snapshot.nodata = std::move(bed.nodata);
    snapshot.scale = scale_of(cell_size);
    snapshot.periodic = periodic;
    snapshot.landform = Landform::terrain;
    check_heights(snapshot);
    MeasureSuite suite(measured_landform(snapshot), snapshot, {channel_area});
    const std::vector<double> values = suite.row(snapshot);
    std::vector<std::tuple<std::string, double, std::string, std::string>> measures;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const auto [column, value] =
            in_world_units({suite.columns()[k], values[k]}, snapshot.scale);
        measures.emplace_back(column.name, value, column.unit, column.help);
    }
    return measures;
}

/// A terrain's values of a quantity, NaN where it has none, with its unit and description.
std::tuple<std::shared_ptr<const Grid>, std::string, std::string> raster_of_bed(
    Bed bed, const CellSize& cell_size, const std::string& quantity, const HillLight& light) {
    Snapshot snapshot;
    snapshot.bed = std::move(bed.heights);
    snapshot.nodata = std::move(bed.nodata);
    snapshot.scale = scale_of(cell_size);
    Raster raster = make_raster(quantity, {snapshot, nullptr, light});
    for (std::size_t cell = 0; cell < raster.nodata.size(); ++cell) {
        if (raster.nodata.values()[cell] != 0)
            raster.values.values()[cell] = std::numeric_limits<double>::quiet_NaN();
    }
    return {std::make_shared<const Grid>(std::move(raster.values)), raster.unit, raster.long_name};
}

}  // namespace

void define_beds(py::module_& core) {
    py::class_<BedPainter>(core, "BedPainter")
        .def(py::init([](const SceneValue& scene, const GridArray& heights,
                         const std::optional<MaskArray>& nodata, const CellSize& cell_size,
                         const std::optional<GeoReferenceTuple>& place,
                         const std::optional<ImageArray>& drape) {
                 Scene copy = scene.scene();
                 Bed bed = bed_of(heights, nodata);
                 std::optional<Image> laid;
                 if (drape) laid = image_of(*drape);
                 const py::gil_scoped_release unlocked;
                 return std::make_unique<BedPainter>(std::move(copy), std::move(bed), cell_size,
                                                     place, std::move(laid));
             }),
             py::arg("scene"), py::arg("heights"), py::arg("nodata"), py::arg("cell_size"),
             py::arg("place") = py::none(), py::arg("drape") = py::none())
        .def("first",
             [](const BedPainter& painter) {
                 Drawing drawing;
                 {
                     const py::gil_scoped_release unlocked;
                     drawing = painter.draw(std::nullopt);
                 }
                 return drawn_of(std::move(drawing));
             })
        .def("layers",
             [](const BedPainter& painter) {
                 LayersDrawing drawing;
                 {
                     const py::gil_scoped_release unlocked;
                     drawing = painter.draw_layers();
                 }
                 return layers_of(std::move(drawing));
             })
        .def(
            "draw",
            [](const BedPainter& painter, const GridArray& heights,
               const std::optional<MaskArray>& nodata) {
                Bed bed = bed_of(heights, nodata);
                Drawing drawing;
                {
                    const py::gil_scoped_release unlocked;
                    drawing = painter.draw(std::move(bed));
                }
                return drawn_of(std::move(drawing));
            },
            py::arg("heights"), py::arg("nodata"));
    core.def(
        "measure_bed",
        [](const GridArray& heights, const std::optional<MaskArray>& nodata,
           const CellSize& cell_size, bool periodic, double channel_area) {
            Bed bed = bed_of(heights, nodata);
            const py::gil_scoped_release unlocked;
            return measures_of_bed(std::move(bed), cell_size, periodic, channel_area);
        },
        py::arg("heights"), py::arg("nodata"), py::arg("cell_size"), py::arg("periodic"),
        py::arg("channel_area"));
    core.def(
        "raster_of_bed",
        [](const GridArray& heights, const std::optional<MaskArray>& nodata,
           const CellSize& cell_size, const std::string& quantity, double azimuth, double elevation,
           double exaggeration) {
            Bed bed = bed_of(heights, nodata);
            std::tuple<std::shared_ptr<const Grid>, std::string, std::string> made;
            {
                const py::gil_scoped_release unlocked;
                made = raster_of_bed(std::move(bed), cell_size, quantity,
                                     {azimuth, elevation, exaggeration});
            }
            const auto& [values, unit, long_name] = made;
            return py::make_tuple(view_of(*values, values), unit, long_name);
        },
        py::arg("heights"), py::arg("nodata"), py::arg("cell_size"), py::arg("quantity"),
        py::arg("azimuth"), py::arg("elevation"), py::arg("exaggeration"));
    core.def(
        "metres_per_degree",
        [](double latitude) {
            const DegreeLengths lengths = degree_lengths(latitude);
            return std::pair(lengths.east, lengths.north);
        },
        py::arg("latitude"));
    core.def(
        "metres_per_unit", [](const std::string& unit) { return metres_per_unit(unit); },
        py::arg("unit"));
    core.def(
        "metres_per_height", [](const std::string& unit) { return metres_per_height(unit); },
        py::arg("unit"));
    core.def(
        "is_degrees", [](const std::string& unit) { return is_degrees(unit); }, py::arg("unit"));
    core.def("grows_downward", &grows_downward, py::arg("positive"), py::arg("standard_name"));
}

}  // namespace fumon::python
