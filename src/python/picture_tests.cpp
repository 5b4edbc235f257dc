#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "outputs/output_claims.h"
#include "picture/baseline.h"
#include "picture/baseline_records.h"
#include "picture/environment.h"
#include "picture/pixels/ignore_rules.h"
#include "picture/pixels/ignored_pixels.h"
#include "picture/verdict.h"
#include "python/arrays.h"
#include "python/module.h"
#include "verify/verify_page.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

IgnoredPixels ignored_of(const ImageArray& image,
                         const std::vector<std::array<std::int64_t, 4>>& boxes,
                         const std::optional<ImageArray>& mask) {
    IgnoreRules rules;
    for (const auto& [x, y, width, height] : boxes) {
        if (x < 0 || y < 0 || width < 1 || height < 1) {
            throw InputError(
                fmt::format("ignore: ({}, {}, {}, {}) is not a box of pixels (x, y, width, height)",
                            x, y, width, height));
        }
        rules.boxes.push_back({x, y, width, height});
    }
    const Image picture = image_of(image);
    IgnoredPixels ignored = ignored_pixels(rules, picture, {});
    if (mask) {
        const Image white = image_of(*mask);
        if (white.width != picture.width || white.height != picture.height) {
            throw InputError(
                fmt::format("ignore_mask: it has {} x {} pixels; the picture has {} x {}",
                            white.width, white.height, picture.width, picture.height));
        }
        ignored.add(white);
        check_share(ignored);
    }
    return ignored;
}

BaselineRecord record_of(const ImageArray& image, const std::string& environment, std::string state,
                         const IgnoredPixels& ignored) {
    BaselineRecord record;
    record.fumon = FUMON_VERSION;
    if (!environment.empty()) record.environment = parse_environment(environment);
    record.state = std::move(state);
    record.ignored = ignored.hash();
    record.fingerprint = fingerprint_of(blanked(image_of(image), ignored));
    return record;
}

const char* word_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::as_recorded:
            return "as recorded";
        case Outcome::differs:
            return "differs";
        case Outcome::missing:
        case Outcome::failed:
        case Outcome::wrong_input:
            break;
    }
    return "missing";
}

std::pair<std::string, std::string> verdict_on(const BaselineRecord* recorded,
                                               const BaselineRecord& present, const ImageArray& got,
                                               const std::optional<ImageArray>& expected,
                                               bool picture, double thumbnail_difference,
                                               double tile_ssim, const IgnoredPixels& ignored) {
    BaselineCase one;
    one.picture = picture;
    one.thumbnail_difference = thumbnail_difference;
    one.tile_ssim = tile_ssim;
    std::optional<Image> kept;
    if (expected) kept = image_of(*expected);
    const Verdict verdict =
        judge(one, recorded, present, image_of(got), kept ? &*kept : nullptr, {}, ignored);
    return {word_of(verdict.outcome), verdict.finding};
}

/// The page of `fumon verify`, for pictures that Python tests.
class DifferencePage {
  public:
    explicit DifferencePage(const std::string& folder) {
        page_.emplace(folder, OutputClaims(false));
        page_->remove_old();
        file_ = page_->file().string();
    }

    void add(const std::string& suite, const std::string& name, const std::string& finding,
             const ImageArray& got, const BaselineRecord* recorded,
             const std::optional<ImageArray>& expected, const IgnoredPixels& ignored) {
        if (!page_) throw Error(file_ + " is finished");
        std::optional<Image> kept;
        if (expected) kept = image_of(*expected);
        page_->add(suite, name, {Outcome::differs, finding}, image_of(got), recorded,
                   kept ? &*kept : nullptr, ignored);
    }

    /// Ends the page and frees its folder; whether there is a page.
    bool finish() {
        const bool any = page_ && page_->has_cases();
        if (page_) page_->finish();
        page_.reset();
        return any;
    }

    [[nodiscard]] const std::string& file() const { return file_; }

  private:
    std::optional<VerifyPage> page_;
    std::string file_;
};

}  // namespace

void define_picture_tests(py::module_& core) {
    py::class_<IgnoredPixels>(core, "IgnoredPixels")
        .def(py::init(&ignored_of), py::arg("image"), py::arg("boxes"), py::arg("mask"));
    py::class_<BaselineRecord>(core, "Record")
        .def(py::init(&record_of), py::arg("image"), py::arg("environment"), py::arg("state"),
             py::arg("ignored"))
        .def_property_readonly(
            "pinned", [](const BaselineRecord& record) { return record.environment.pinned; })
        .def_property_readonly(
            "pixels", [](const BaselineRecord& record) { return hex(record.fingerprint.pixels); })
        .def("changes", &changes, py::arg("after"));
    core.def(
        "read_lock", [](const std::string& file) { return read_lock(file, LockOwner::pytest); },
        py::arg("file"));
    core.def(
        "write_lock",
        [](const std::string& file, const BaselineRecords& records) {
            write_file(file, lock_text(records, LockOwner::pytest));
        },
        py::arg("file"), py::arg("records"));
    core.def("judge", &verdict_on, py::arg("recorded"), py::arg("present"), py::arg("got"),
             py::arg("expected"), py::arg("picture"), py::arg("thumbnail_difference"),
             py::arg("tile_ssim"), py::arg("ignored"));
    py::class_<DifferencePage>(core, "DifferencePage")
        .def(py::init<const std::string&>(), py::arg("folder"))
        .def("add", &DifferencePage::add, py::arg("suite"), py::arg("name"), py::arg("finding"),
             py::arg("got"), py::arg("recorded"), py::arg("expected"), py::arg("ignored"))
        .def("finish", &DifferencePage::finish)
        .def_property_readonly("file", &DifferencePage::file);
}

}  // namespace fumon::python
