#include "python/arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "picture/environment.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

template <class Number>
py::array read_only(const Number* values, std::vector<py::ssize_t> shape,
                    std::shared_ptr<const void> owner) {
    auto kept = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
    const py::capsule base(kept.get(), [](void* pointer) {
        delete static_cast<std::shared_ptr<const void>*>(pointer);
    });
    static_cast<void>(kept.release());  // the capsule's now
    py::array_t<Number> array(std::move(shape), values, base);
    array.attr("flags").attr("writeable") = false;
    return array;
}

template <class Number>
py::array view(const Field<Number>& field, std::shared_ptr<const void> owner) {
    return read_only(field.data(), {field.ny(), field.nx()}, std::move(owner));
}

template <class Number, class Array>
Field<Number> field_of_array(const Array& array) {
    if (array.ndim() != 2) {
        throw InputError(
            fmt::format("the array has {} dimensions; it takes 2: rows (northward) "
                        "and columns (eastward)",
                        array.ndim()));
    }
    if (array.shape(0) < 1 || array.shape(1) < 1) throw InputError("the array has no cells");
    constexpr auto longest = static_cast<py::ssize_t>(largest_grid_side);
    if (array.shape(0) > longest || array.shape(1) > longest ||
        array.shape(0) * array.shape(1) > largest_grid_cells) {
        throw InputError(fmt::format("the array has {} x {} cells; at most {}", array.shape(0),
                                     array.shape(1), largest_grid_cells));
    }
    Field<Number> field(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    std::copy_n(array.data(), field.size(), field.data());
    return field;
}

std::vector<std::uint8_t> interleaved(const Image& image) {
    std::vector<std::uint8_t> levels;
    levels.reserve(4 * image.alpha.size());
    for (std::size_t pixel = 0; pixel < image.alpha.size(); ++pixel) {
        levels.insert(levels.end(), image.rgb.data() + 3 * pixel, image.rgb.data() + 3 * pixel + 3);
        levels.push_back(image.alpha[pixel]);
    }
    return levels;
}

}  // namespace

py::array view_of(const Grid& grid, std::shared_ptr<const void> owner) {
    return view(grid, std::move(owner));
}

py::array view_of(const Mask& mask, std::shared_ptr<const void> owner) {
    return view(mask, std::move(owner));
}

Grid grid_of(const GridArray& array) {
    return field_of_array<double>(array);
}

Mask mask_of(const MaskArray& array) {
    return field_of_array<std::uint8_t>(array);
}

py::array array_of(Image image) {
    const std::vector<py::ssize_t> shape{image.height, image.width, image.transparent() ? 4 : 3};
    auto kept = std::make_unique<std::vector<std::uint8_t>>(
        image.transparent() ? interleaved(image) : std::move(image.rgb));
    const std::uint8_t* levels = kept->data();
    const py::capsule base(
        kept.get(), [](void* pointer) { delete static_cast<std::vector<std::uint8_t>*>(pointer); });
    static_cast<void>(kept.release());  // the capsule's now
    return py::array_t<std::uint8_t>(shape, levels, base);
}

py::tuple drawn_of(Drawing drawing) {
    const std::string environment = environment_text(drawing.record.environment);
    return py::make_tuple(array_of(std::move(drawing.image)), environment);
}

py::tuple layers_of(LayersDrawing drawing) {
    const std::vector<py::ssize_t> shape{drawing.layers.height, drawing.layers.width};
    py::list layers;
    for (ImageLayer& layer : drawing.layers.layers) {
        auto kept = std::make_unique<std::vector<float>>(std::move(layer.values));
        const float* values = kept->data();
        const py::capsule base(
            kept.get(), [](void* pointer) { delete static_cast<std::vector<float>*>(pointer); });
        static_cast<void>(kept.release());  // the capsule's now
        layers.append(
            py::make_tuple(layer.name, layer.unit, py::array_t<float>(shape, values, base)));
    }
    return py::make_tuple(layers, environment_text(drawing.record.environment));
}

Image image_of(const ImageArray& array) {
    const bool coloured = array.ndim() == 3 && (array.shape(2) == 3 || array.shape(2) == 4);
    if (!coloured || array.shape(0) < 1 || array.shape(1) < 1) {
        throw InputError(
            "a picture is an array (height, width, 3) of red, green and blue, 8 bits each, or "
            "(height, width, 4) with alpha");
    }
    constexpr py::ssize_t largest_side = 65'535;
    if (array.shape(0) > largest_side || array.shape(1) > largest_side)
        throw InputError(fmt::format("a picture has at most {} pixels a side", largest_side));
    Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    if (array.shape(2) == 3) {
        std::copy_n(array.data(), image.rgb.size(), image.rgb.data());
        return image;
    }
    image.alpha.resize(image.rgb.size() / 3);
    const std::uint8_t* from = array.data();
    for (std::size_t pixel = 0; pixel < image.alpha.size(); ++pixel, from += 4) {
        std::copy_n(from, 3, image.rgb.data() + 3 * pixel);
        image.alpha[pixel] = from[3];
    }
    return image;
}

}  // namespace fumon::python
