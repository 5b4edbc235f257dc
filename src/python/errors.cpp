#include <exception>
#include <utility>

#include "base/cancellation.h"
#include "base/error.h"
#include "python/module.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

// Live as long as the interpreter, which may outlive every static destructor.
PyObject* error_class = nullptr;
PyObject* input_error_class = nullptr;

PyObject* make_class(const char* name, const char* doc, const py::object& bases) {
    PyObject* made = PyErr_NewExceptionWithDoc(name, doc, bases.ptr(), nullptr);
    if (made == nullptr) throw py::error_already_set();
    return made;
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
        PyErr_SetString(input_error_class, error.what());
    } catch (const Error& error) {
        PyErr_SetString(error_class, error.what());
    } catch (const Cancelled&) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
}

}  // namespace

void define_errors(py::module_& core) {
    error_class = make_class("fumon.Error", "What fumon cannot do: a failure while working.",
                             py::reinterpret_borrow<py::object>(PyExc_Exception));
    const auto error = py::reinterpret_borrow<py::object>(error_class);
    input_error_class =
        make_class("fumon.InputError",
                   "A scene, a setting, a file or an array is wrong; a line for each fault, with "
                   "file:line:column where there is one.",
                   py::make_tuple(error, py::reinterpret_borrow<py::object>(PyExc_ValueError)));
    core.attr("Error") = error;
    core.attr("InputError") = py::reinterpret_borrow<py::object>(input_error_class);
    py::register_exception_translator(&translate);
}

}  // namespace fumon::python
