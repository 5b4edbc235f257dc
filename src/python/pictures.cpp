#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "files/atomic_file.h"
#include "picture/compare.h"
#include "picture/fingerprint.h"
#include "picture/fingerprint_text.h"
#include "picture/png.h"
#include "picture/stills/picture_file.h"
#include "python/arrays.h"
#include "python/module.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

py::bytes encoded(const ImageArray& array, const std::string& file,
                  std::optional<double> dots_per_inch, int quality, bool lossless) {
    const Image image = image_of(array);
    std::vector<std::uint8_t> bytes;
    {
        const py::gil_scoped_release unlocked;
        bytes = encode_picture(image, picture_format(file), {quality, lossless},
                               dots_per_inch.value_or(screen_dots_per_inch), own_text());
    }
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

py::dict comparison_of(const ImageArray& first_array, const ImageArray& second_array) {
    const Image first = image_of(first_array);
    const Image second = image_of(second_array);
    Comparison found;
    {
        const py::gil_scoped_release unlocked;
        found = compare(first, second);
    }
    py::dict result;
    result["likeness"] = std::string(name_of(likeness(found)));
    result["largest"] = found.largest;
    result["changed"] = found.changed;
    result["changed_share"] = found.changed_share;
    result["mean"] = found.mean;
    result["tile_ssim"] = found.tiles.smallest;
    result["thumbnail"] = found.thumbnail.largest;
    return result;
}

py::dict fingerprint_dict(const ImageArray& array) {
    const Image image = image_of(array);
    Fingerprint found;
    {
        const py::gil_scoped_release unlocked;
        found = fingerprint_of(image);
    }
    py::array_t<double> thumbnail({Thumbnail::height, Thumbnail::width, 3});
    std::copy(found.thumbnail.levels.begin(), found.thumbnail.levels.end(),
              thumbnail.mutable_data());
    py::dict result;
    result["width"] = found.width;
    result["height"] = found.height;
    result["pixels_sha256"] = hex(found.pixels);
    result["dhash"] = dhash_text(found.difference_hash);
    result["thumbnail"] = thumbnail;
    return result;
}

}  // namespace

void define_pictures(py::module_& core) {
    core.def("encoded", &encoded, py::arg("image"), py::arg("file") = ".png",
             py::arg("dots_per_inch") = py::none(), py::arg("quality") = PictureCoding{}.quality,
             py::arg("lossless") = false);
    core.def(
        "read_picture",
        [](const std::string& file) {
            Image image;
            {
                const py::gil_scoped_release unlocked;
                image = read_picture(file);
            }
            return array_of(std::move(image));
        },
        py::arg("file"));
    core.def(
        "write_file",
        [](const std::string& file, const py::bytes& bytes) {
            const std::string text = bytes;
            const py::gil_scoped_release unlocked;
            write_file(file, std::string_view(text));
        },
        py::arg("file"), py::arg("bytes"));
    core.def("compare", &comparison_of, py::arg("first"), py::arg("second"));
    core.def(
        "difference",
        [](const ImageArray& first, const ImageArray& second) {
            return array_of(difference_picture(image_of(first), image_of(second)));
        },
        py::arg("first"), py::arg("second"));
    core.def("fingerprint", &fingerprint_dict, py::arg("image"));
}

}  // namespace fumon::python
