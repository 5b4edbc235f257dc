#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "python/arrays.h"
#include "python/geo_references.h"
#include "python/module.h"
#include "scene/beds/memory_bed.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

using CellSize = std::optional<std::pair<double, double>>;
/// A bed that Python keeps for its scenes, as its constructor's arguments for pickle.
struct MemoryBedHandle {
    GridArray heights;
    std::optional<MaskArray> nodata;
    CellSize cell_size;
    std::optional<GeoReferenceTuple> place;
    std::optional<bool> unit_counts;
    std::shared_ptr<const MemoryBed> held{};
};

MemoryBedHandle memory_bed_handle(const GridArray& heights, const std::optional<MaskArray>& nodata,
                                  const CellSize& cell_size,
                                  const std::optional<GeoReferenceTuple>& place,
                                  std::optional<bool> unit_counts) {
    MemoryBedHandle kept{heights, nodata, cell_size, place, unit_counts};
    Terrain terrain;
    terrain.heights = grid_of(heights);
    if (nodata) terrain.nodata = mask_of(*nodata);
    const py::gil_scoped_release unlocked;
    if (cell_size) std::tie(terrain.dx, terrain.dy) = *cell_size;
    if (place) terrain.place = geo_reference_of(*place);
    kept.held = MemoryBed::hold(std::move(terrain), unit_counts);
    return kept;
}

}  // namespace

void define_memory_beds(py::module_& core) {
    py::class_<MemoryBedHandle>(core, "HeldBed")
        .def(py::init(&memory_bed_handle), py::arg("heights"), py::arg("nodata"),
             py::arg("cell_size"), py::arg("place"), py::arg("unit_counts"))
        .def_property_readonly("name", [](const MemoryBedHandle& bed) { return bed.held->name(); })
        .def(py::pickle(
            [](const MemoryBedHandle& bed) {
                return py::make_tuple(bed.heights, bed.nodata, bed.cell_size, bed.place,
                                      bed.unit_counts);
            },
            [](const py::tuple& state) {
                return memory_bed_handle(
                    state[0].cast<GridArray>(), state[1].cast<std::optional<MaskArray>>(),
                    state[2].cast<CellSize>(), state[3].cast<std::optional<GeoReferenceTuple>>(),
                    state[4].cast<std::optional<bool>>());
            }));
}

}  // namespace fumon::python
