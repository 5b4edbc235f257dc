#include <pybind11/stl.h>

#include <string>
#include <tuple>
#include <vector>

#include "python/arrays.h"
#include "python/live_run.h"
#include "python/module.h"
#include "python/projections.h"
#include "python/scene_value.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

py::dict fields_of(const Step& step) {
    py::dict fields;
    for (const SnapshotField& field : step.snapshot->fields)
        fields[py::str(field.name)] = view_of(field.values, step.snapshot);
    return fields;
}

/// Name → (unit, what it is) of the fields.
py::dict notes_of_fields(const Step& step) {
    py::dict notes;
    for (const SnapshotField& field : step.snapshot->fields)
        notes[py::str(field.name)] = py::make_tuple(field.unit, field.long_name);
    return notes;
}

py::dict numbers_of(const Step& step) {
    py::dict numbers;
    for (const SnapshotNumber& number : step.snapshot->numbers)
        numbers[py::str(number.name)] = number.value;
    return numbers;
}

/// (name, value, unit, help) of each measure.
std::vector<std::tuple<std::string, double, std::string, std::string>> measures_of(
    const Step& step) {
    std::vector<std::tuple<std::string, double, std::string, std::string>> measures;
    for (std::size_t k = 0; k < step.columns.size(); ++k) {
        const MeasureColumn& column = step.columns[k];
        measures.emplace_back(column.name, step.values[k], column.unit, column.help);
    }
    return measures;
}

Drawing drawing_of(const Step& step) {
    const py::gil_scoped_release unlocked;
    return step.drawer->draw(step.snapshot, step.plotted);
}

LayersDrawing layers_drawing_of(const Step& step) {
    const py::gil_scoped_release unlocked;
    return step.drawer->draw_layers(step.snapshot);
}

/// The file that `encode` makes of a drawing of a step.
template <class Drawn, class Encode>
py::bytes file_of(const Step& step, const Drawn& drawing, const Encode& encode) {
    std::vector<std::uint8_t> bytes;
    {
        const py::gil_scoped_release unlocked;
        bytes = encode(step.drawer->scene(), step.drawer->inputs(), step.snapshot->step, drawing);
    }
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void define_runs(py::module_& core) {
    py::class_<Step, std::shared_ptr<Step>>(core, "Step")
        .def_property_readonly("step", [](const Step& step) { return step.snapshot->step; })
        .def_property_readonly("time", [](const Step& step) { return step.snapshot->time; })
        .def_property_readonly("time_unit",
                               [](const Step& step) { return step.snapshot->time_unit; })
        .def_property_readonly(
            "bed", [](const Step& step) { return view_of(step.snapshot->bed, step.snapshot); })
        .def_property_readonly("nodata",
                               [](const Step& step) -> py::object {
                                   const Mask& mask = step.snapshot->nodata;
                                   if (mask.empty()) return py::none();
                                   return view_of(mask, step.snapshot);
                               })
        .def_property_readonly("cell_size",
                               [](const Step& step) -> py::object {
                                   const WorldScale& scale = step.snapshot->scale;
                                   if (!scale.in_metres) return py::none();
                                   return py::make_tuple(scale.dx, scale.dy);
                               })
        .def_property_readonly("height_unit",
                               [](const Step& step) -> py::object {
                                   const WorldScale& scale = step.snapshot->scale;
                                   if (!scale.in_metres) return py::none();
                                   return py::cast(scale.height_unit);
                               })
        .def_property_readonly("fields", &fields_of)
        .def_property_readonly("field_notes", &notes_of_fields)
        .def_property_readonly("numbers", &numbers_of)
        .def_property_readonly("measured", &measures_of)
        .def("drawn", [](const Step& step) { return drawn_of(drawing_of(step)); })
        .def(
            "still",
            [](const Step& step, const std::string& file) {
                return file_of(step, drawing_of(step),
                               [&](const Scene& scene, const std::vector<InputFile>& inputs,
                                   std::int64_t number, const Drawing& drawing) {
                                   return still_file(scene, inputs, number, drawing,
                                                     picture_format(file), step.drawer->results());
                               });
            },
            py::arg("file"))
        .def("projection",
             [](const Step& step) {
                 return projection_of(step.drawer->scene(), *step.drawer->first(), *step.snapshot);
             })
        .def("layers", [](const Step& step) { return layers_of(layers_drawing_of(step)); })
        .def("exr", [](const Step& step) {
            return file_of(step, layers_drawing_of(step),
                           [&](const Scene& scene, const std::vector<InputFile>& inputs,
                               std::int64_t number, const LayersDrawing& drawing) {
                               return layers_file(scene, inputs, number, drawing,
                                                  step.drawer->results());
                           });
        });

    py::class_<LiveRun>(core, "LiveRun")
        .def(py::init([](const SceneValue& scene, int threads, bool measures) {
                 Scene copy = scene.scene();
                 const py::gil_scoped_release unlocked;
                 return std::make_unique<LiveRun>(std::move(copy), threads, measures);
             }),
             py::arg("scene"), py::arg("threads"), py::arg("measures"))
        .def("advance", &LiveRun::advance, py::arg("step"),
             py::call_guard<py::gil_scoped_release>())
        .def("present",
             [](LiveRun& run) {
                 const py::gil_scoped_release unlocked;
                 return std::make_shared<Step>(run.present());
             })
        .def("present_as_still",
             [](LiveRun& run) {
                 const py::gil_scoped_release unlocked;
                 return std::make_shared<Step>(run.present_as_still());
             })
        .def("state_hash", &LiveRun::state_hash, py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("steps_done",
                               [](LiveRun& run) {
                                   const py::gil_scoped_release unlocked;
                                   return run.steps_done();
                               })
        .def_property_readonly("last_step", &LiveRun::last_step)
        .def_property_readonly("note", &LiveRun::note);
}

}  // namespace fumon::python
