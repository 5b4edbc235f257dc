#include "python/module.h"

PYBIND11_MODULE(_core, core) {
    fumon::python::define(core);
}
