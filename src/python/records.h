#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <vector>

#include "foreign/foreign_run.h"

namespace fumon::python {

/// A run whose records Python reads, one at a time, as they are asked for.
class RecordSource {
  public:
    /// `readers`: by quantity ("bed", "depth" …) what gives the values of a record, float64
    /// (ny, nx), row 0 southernmost, NaN where there are none, in fumon's unit.
    RecordSource(ForeignRun outline, std::map<std::string, pybind11::function> readers);

    [[nodiscard]] ForeignRun run() const;

  private:
    ForeignRun outline_;
    std::map<std::string, pybind11::function> readers_;
};

/// Defines RecordSource and what recognises the variables of a dataset.
void define_records(pybind11::module_& core);

}  // namespace fumon::python
