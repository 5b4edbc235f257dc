#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "foreign/mesh/mesh_grid.h"
#include "python/arrays.h"
#include "python/module.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Patches = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

std::vector<double> values_of(const Numbers& numbers) {
    return {numbers.data(), numbers.data() + numbers.size()};
}

/// Counts places from the lowest of those that are a corner; others, which lie in no patch, are 0.
void count_from_lowest(std::vector<double>& places, const std::vector<std::int32_t>& corners) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::int32_t node : corners) {
        const double place = places[static_cast<std::size_t>(node)];
        if (!std::isfinite(place))
            throw InputError("a node of the grid's patches is at no finite place");
        lowest = std::min(lowest, place);
    }
    std::vector<double> counted(places.size(), 0.0);
    for (const std::int32_t node : corners)
        counted[static_cast<std::size_t>(node)] = places[static_cast<std::size_t>(node)] - lowest;
    places = std::move(counted);
}

/// Nodes and the triangles or polygons between them, for values of the nodes to be laid on cells.
class NodeMesh {
  public:
    NodeMesh(const Numbers& x, const Numbers& y, const Patches& patches, double cell) {
        if (x.size() != y.size() || patches.ndim() != 2)
            throw InputError(
                "a grid of nodes needs as many x as y, and patches as (number, corners)");
        FaceMesh mesh{values_of(x), values_of(y), {}, {}};
        nodes_ = mesh.x.size();
        for (py::ssize_t patch = 0; patch < patches.shape(0); ++patch) {
            const std::size_t begin = mesh.corners.size();
            for (py::ssize_t corner = 0; corner < patches.shape(1); ++corner) {
                const std::int64_t node = patches.at(patch, corner);
                if (node < 0) continue;  // of a patch with fewer corners
                if (std::cmp_greater_equal(node, nodes_))
                    throw InputError("a patch of the grid has a node that the grid has not");
                mesh.corners.push_back(static_cast<std::int32_t>(node));
            }
            if (mesh.corners.size() < begin + 3) {
                mesh.corners.resize(begin);
            } else {
                mesh.ends.push_back(mesh.corners.size());
            }
        }
        if (mesh.faces() == 0) throw InputError("a grid of nodes without patches has no ground");
        count_from_lowest(mesh.x, mesh.corners);
        count_from_lowest(mesh.y, mesh.corners);
        cell_ = cell > 0.0 ? cell : cell_of_edges(mesh);
        if (!(cell_ > 0.0))
            throw InputError("the nodes of the grid's patches lie at one place; it has no ground");
        const double cells = (*std::ranges::max_element(mesh.x) / cell_ + 1.0) *
                             (*std::ranges::max_element(mesh.y) / cell_ + 1.0);
        if (!(cells <= static_cast<double>(largest_grid_cells)))
            throw InputError("its cells would be too many; give a larger cell_size");
        grid_ = std::make_unique<MeshGrid>(std::move(mesh), cell_);
    }

    [[nodiscard]] double cell() const { return cell_; }

    [[nodiscard]] py::array laid(const Numbers& values) const {
        if (std::cmp_not_equal(values.size(), nodes_))
            throw InputError("a field of the grid has another number of values than it has nodes");
        const auto grid = std::make_shared<const Grid>(grid_->of_nodes({values.data(), nodes_}));
        return view_of(*grid, grid);
    }

  private:
    std::size_t nodes_ = 0;
    double cell_ = 1.0;
    std::unique_ptr<MeshGrid> grid_;
};

}  // namespace

void define_node_mesh(py::module_& core) {
    py::class_<NodeMesh>(core, "NodeMesh")
        .def(py::init<const Numbers&, const Numbers&, const Patches&, double>(), py::arg("x"),
             py::arg("y"), py::arg("patches"), py::arg("cell"))
        .def_property_readonly("cell", &NodeMesh::cell)
        .def("laid", &NodeMesh::laid, py::arg("values"));
}

}  // namespace fumon::python
