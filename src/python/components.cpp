#include <pybind11/stl.h>

#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "bmi/component.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/process.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

/// Values as a caller hands them over.
using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<int, py::array::c_style | py::array::forcecast>;

/// What Python's component is built on: the C++ one, its arrays with their sizes checked.
class Component {
  public:
    void initialize(const std::string& scene) { bmi().Initialize(scene); }
    /// Throws Error in a fork, where its threads are not.
    BmiComponent& bmi() {
        process_.check();
        return bmi_;
    }

    [[nodiscard]] std::size_t items(const std::string& name) {
        return static_cast<std::size_t>(bmi().GetVarNbytes(name)) / sizeof(double);
    }

    py::array_t<double> value(const std::string& name) {
        py::array_t<double> values(static_cast<py::ssize_t>(items(name)));
        bmi().GetValue(name, values.mutable_data());
        return values;
    }

    /// A view of the component's own memory, which nobody can write to.
    static py::array value_pointer(const py::object& self, const std::string& name) {
        auto& component = self.cast<Component&>();
        const auto* values = static_cast<const double*>(component.bmi().GetValuePtr(name));
        py::array_t<double> view(static_cast<py::ssize_t>(component.items(name)), values, self);
        view.attr("flags").attr("writeable") = false;
        return view;
    }

    void set(const std::string& name, const Values& values) {
        if (static_cast<std::size_t>(values.size()) != items(name)) {
            throw InputError(name + " has " + std::to_string(items(name)) + " values, not " +
                             std::to_string(values.size()));
        }
        std::vector<double> copy(values.data(), values.data() + values.size());
        bmi().SetValue(name, copy.data());
    }

    void set_at(const std::string& name, const Indices& indices, const Values& values) {
        if (values.size() != indices.size())
            throw InputError(name + ": as many values as indices are needed");
        std::vector<int> places(indices.data(), indices.data() + indices.size());
        std::vector<double> copy(values.data(), values.data() + values.size());
        bmi().SetValueAtIndices(name, places.data(), static_cast<int>(places.size()), copy.data());
    }

  private:
    Process process_;
    BmiComponent bmi_;
};

using Unlocked = py::call_guard<py::gil_scoped_release>;

/// A member that fills an array of numbers, as one that returns it.
template <auto fill, auto size, class Number>
py::array_t<Number> filled(Component& component, int grid) {
    py::array_t<Number> values(static_cast<py::ssize_t>(size(component.bmi(), grid)));
    (component.bmi().*fill)(grid, values.mutable_data());
    return values;
}

int two(BmiComponent& /*bmi*/, int /*grid*/) {
    return 2;
}
int columns(BmiComponent& bmi, int grid) {
    std::array<int, 2> shape{};
    bmi.GetGridShape(grid, shape.data());
    return shape[1];
}
int rows(BmiComponent& bmi, int grid) {
    std::array<int, 2> shape{};
    bmi.GetGridShape(grid, shape.data());
    return shape[0];
}
int faces(BmiComponent& bmi, int grid) {
    return bmi.GetGridFaceCount(grid);
}
int face_corners(BmiComponent& bmi, int grid) {
    return 4 * bmi.GetGridFaceCount(grid);
}
int edge_ends(BmiComponent& bmi, int grid) {
    return 2 * bmi.GetGridEdgeCount(grid);
}

template <auto member>
auto of_grid() {
    return [](Component& component, int grid) { return (component.bmi().*member)(grid); };
}
template <auto member>
auto of_name() {
    return [](Component& component, const std::string& name) {
        return (component.bmi().*member)(name);
    };
}
template <auto member>
auto of_component() {
    return [](Component& component) { return (component.bmi().*member)(); };
}

}  // namespace

void define_components(py::module_& core) {
    using B = BmiComponent;
    py::class_<Component>(core, "Component")
        .def(py::init<>())
        .def("initialize", &Component::initialize, py::arg("scene"), Unlocked())
        .def("update", of_component<&B::Update>(), Unlocked())
        .def("finalize", of_component<&B::Finalize>())
        .def("component_name", of_component<&B::GetComponentName>())
        .def("input_names", of_component<&B::GetInputVarNames>())
        .def("output_names", of_component<&B::GetOutputVarNames>())
        .def("var_grid", of_name<&B::GetVarGrid>(), py::arg("name"))
        .def("var_units", of_name<&B::GetVarUnits>(), py::arg("name"))
        .def("current_time", of_component<&B::GetCurrentTime>())
        .def("end_time", of_component<&B::GetEndTime>(), Unlocked())
        .def("time_step", of_component<&B::GetTimeStep>(), Unlocked())
        .def("time_units", of_component<&B::GetTimeUnits>())
        .def("value", &Component::value, py::arg("name"))
        .def("value_pointer", &Component::value_pointer, py::arg("name"))
        .def("set", &Component::set, py::arg("name"), py::arg("values"))
        .def("set_at", &Component::set_at, py::arg("name"), py::arg("indices"), py::arg("values"))
        .def("grid_rank", of_grid<&B::GetGridRank>(), py::arg("grid"))
        .def("grid_size", of_grid<&B::GetGridSize>(), py::arg("grid"))
        .def("grid_type", of_grid<&B::GetGridType>(), py::arg("grid"))
        .def("grid_edge_count", of_grid<&B::GetGridEdgeCount>(), py::arg("grid"))
        .def("grid_face_count", of_grid<&B::GetGridFaceCount>(), py::arg("grid"))
        .def("grid_shape", &filled<&B::GetGridShape, two, int>, py::arg("grid"))
        .def("grid_spacing", &filled<&B::GetGridSpacing, two, double>, py::arg("grid"))
        .def("grid_origin", &filled<&B::GetGridOrigin, two, double>, py::arg("grid"))
        .def("grid_x", &filled<&B::GetGridX, columns, double>, py::arg("grid"))
        .def("grid_y", &filled<&B::GetGridY, rows, double>, py::arg("grid"))
        .def("grid_z", &filled<&B::GetGridZ, two, double>, py::arg("grid"))
        .def("grid_edge_nodes", &filled<&B::GetGridEdgeNodes, edge_ends, int>, py::arg("grid"))
        .def("grid_face_edges", &filled<&B::GetGridFaceEdges, face_corners, int>, py::arg("grid"))
        .def("grid_face_nodes", &filled<&B::GetGridFaceNodes, face_corners, int>, py::arg("grid"))
        .def("grid_nodes_per_face", &filled<&B::GetGridNodesPerFace, faces, int>, py::arg("grid"));
}

}  // namespace fumon::python
