#include "python/module.h"

#include <filesystem>
#include <string>

#include "base/data_files.h"
#include "gl/pinned.h"

namespace fumon::python {

void define(pybind11::module_& core) {
    core.doc() = "What the package fumon is built on; use that.";
    core.attr("version") = FUMON_VERSION;
    define_errors(core);
    core.def("add_data_folder", [](const std::string& folder) { add_data_folder(folder); });
    core.def("pin_rendering", &gl::pin_rendering);
    define_scenes(core);
    define_runs(core);
    define_results(core);
    define_node_mesh(core);
    define_beds(core);
    define_memory_beds(core);
    define_projections(core);
    define_pictures(core);
    define_movies(core);
    define_sweeps(core);
    define_views(core);
    define_components(core);
    define_picture_tests(core);
}

}  // namespace fumon::python
