#pragma once

#include <pybind11/pybind11.h>

namespace fumon::python {

/// Defines the module fumon._core, on which the Python package in fumon/ is built: each function
/// some classes or functions of it, the errors first. Results go to Python as views or values; what
/// lasts runs without the interpreter's lock.
void define(pybind11::module_& core);

void define_errors(pybind11::module_& core);
void define_scenes(pybind11::module_& core);
void define_runs(pybind11::module_& core);
void define_results(pybind11::module_& core);
void define_node_mesh(pybind11::module_& core);
void define_beds(pybind11::module_& core);
void define_memory_beds(pybind11::module_& core);
void define_projections(pybind11::module_& core);
void define_pictures(pybind11::module_& core);
void define_movies(pybind11::module_& core);
void define_sweeps(pybind11::module_& core);
void define_views(pybind11::module_& core);
void define_components(pybind11::module_& core);
void define_picture_tests(pybind11::module_& core);

}  // namespace fumon::python
