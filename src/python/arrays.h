#pragma once

#include <pybind11/numpy.h>

#include <memory>

#include "base/grid.h"
#include "base/image.h"
#include "run/still.h"

namespace fumon::python {

/// Heights or other values as Python hands them over: float64, rows packed, row 0 southernmost.
using GridArray = pybind11::array_t<double, pybind11::array::c_style>;
using MaskArray = pybind11::array_t<std::uint8_t, pybind11::array::c_style>;
using ImageArray = pybind11::array_t<std::uint8_t, pybind11::array::c_style>;

/// A view (ny, nx) of a field's own memory that nobody can write to and that keeps `owner` alive.
pybind11::array view_of(const Grid& grid, std::shared_ptr<const void> owner);
pybind11::array view_of(const Mask& mask, std::shared_ptr<const void> owner);

/// Copies of arrays (ny, nx). Throw InputError for another number of dimensions.
Grid grid_of(const GridArray& array);
Mask mask_of(const MaskArray& array);

/// An array (height, width, 3), or (height, width, 4) with the opacities of an image that has them.
pybind11::array array_of(Image image);

/// The same with what drew it, as one line of JSON: (array, text).
pybind11::tuple drawn_of(Drawing drawing);

/// A picture's layers and what drew them: (list of (name, unit, array (height, width) float32),
/// text).
pybind11::tuple layers_of(LayersDrawing drawing);

/// A copy of an array (height, width, 3 or 4). Throws InputError for another shape.
Image image_of(const ImageArray& array);

}  // namespace fumon::python
