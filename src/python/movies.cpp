#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "picture/colour_table.h"
#include "picture/movie.h"
#include "python/arrays.h"
#include "python/module.h"

namespace fumon::python {

namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

const MovieFormat& format_of(const fs::path& file) {
    std::string endings;
    for (const MovieFormat& format : movie_formats()) {
        if (file.extension() == format.ending) return format;
        if (endings.find(format.ending) == std::string::npos)
            endings += (endings.empty() ? "" : ", ") + std::string(format.ending);
    }
    throw InputError(
        fmt::format("{}: the name of a movie must end in one of {}", file.string(), endings));
}

/// A movie that is written frame by frame; its format is that of its ending. A GIF waits for all
/// its frames, since they share their colours.
class MovieWriter {
  public:
    MovieWriter(fs::path file, double rate, int quality)
        : file_(std::move(file)), format_(format_of(file_)), rate_(rate), quality_(quality) {}

    void add(const Image& image) {
        if (image.transparent() && format_.open_pixels.empty())
            return add(composited_on(image, 255));
        if (format_.name == "gif") {
            counts_.add(image);
            waiting_.push_back(image);
        } else {
            if (!movie_) begin(image, nullptr);
            movie_->add(image);
        }
        ++frames_;
    }

    void finish() {
        if (frames_ == 0) throw InputError(file_.string() + ": a movie needs a frame");
        if (!waiting_.empty()) {
            const ColourTable colours(counts_);
            begin(waiting_.front(), &colours);
            for (const Image& image : waiting_) movie_->add(image);
            movie_->finish(own_text());
        } else {
            movie_->finish(own_text());
        }
        movie_.reset();
        waiting_.clear();
    }

  private:
    void begin(const Image& image, const ColourTable* colours) {
        movie_ =
            std::make_unique<Movie>(file_, image.width, image.height, rate_,
                                    MovieCoding{format_, quality_, colours, image.transparent()});
    }

    fs::path file_;
    const MovieFormat& format_;
    double rate_;
    int quality_;
    std::size_t frames_ = 0;
    ColourCounts counts_;
    std::vector<Image> waiting_;
    std::unique_ptr<Movie> movie_;
};

}  // namespace

void define_movies(py::module_& core) {
    py::class_<MovieWriter>(core, "MovieWriter")
        .def(py::init([](const std::string& file, double rate, int quality) {
                 return std::make_unique<MovieWriter>(file, rate, quality);
             }),
             py::arg("file"), py::arg("rate"), py::arg("quality"))
        .def(
            "add",
            [](MovieWriter& movie, const ImageArray& array) {
                const Image image = image_of(array);
                const py::gil_scoped_release unlocked;
                movie.add(image);
            },
            py::arg("image"))
        .def("finish", &MovieWriter::finish, py::call_guard<py::gil_scoped_release>());
}

}  // namespace fumon::python
