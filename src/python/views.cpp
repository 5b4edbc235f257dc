#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "film/beds/stored_still.h"
#include "python/module.h"
#include "python/process.h"
#include "python/scene_value.h"
#include "run/inputs/scene_argument.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "scene/scene_files.h"
#include "scene/terrain_scene.h"
#include "view/server/http_server.h"
#include "view/subject/computed_subject.h"
#include "view/subject/followed_subject.h"
#include "view/subject/stored_subject.h"
#include "view/view_page.h"

namespace fumon::python {

namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

/// The server of a viewer in this process, until it is closed. A fork has none of its threads and
/// leaves it alone.
class LiveView {
  public:
    /// Throws InputError where the port is taken.
    LiveView(std::unique_ptr<ViewSubject> subject, int port, int threads) {
        auto shown = std::make_unique<Shown>();
        ViewOptions options;
        options.work.threads = threads;
        shown->subject = std::move(subject);
        shown->page = std::make_unique<ViewPage>(*shown->subject, options);
        HttpLimits limits;
        limits.in_notebooks = true;
        ViewPage& page = *shown->page;
        shown->server = std::make_unique<HttpServer>(
            [&page](const HttpRequest& request) { return page.answer(request); }, port, limits);
        shown_ = std::move(shown);
    }
    ~LiveView() { close(); }
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    void close() {
        const std::lock_guard lock(mutex_);
        if (!shown_) return;
        if (!process_.is_this()) {
            static_cast<void>(shown_.release());
            return;
        }
        shown_->page->cancel_all();
        shown_->server.reset();
        shown_.reset();
    }

    [[nodiscard]] bool closed() {
        const std::lock_guard lock(mutex_);
        return !shown_;
    }
    /// Empty where it is closed.
    [[nodiscard]] std::string address() {
        const std::lock_guard lock(mutex_);
        return shown_ ? shown_->server->address() : "";
    }

    /// What the page shows at first; empty where that is still to be computed.
    [[nodiscard]] std::string picture(int width) {
        process_.check();
        const std::lock_guard lock(mutex_);
        if (!shown_) throw Error("this viewer is closed");
        const std::string state = shown_->subject->work().state;
        const bool stored = state == "complete" || state == "running" || state == "interrupted" ||
                            state == "failed";
        const std::size_t moments = shown_->subject->moments().size();
        if (moments == 0) return {};
        const std::size_t moment = stored ? moments - 1 : 0;
        const ImageSettings& image = shown_->subject->scene().view.image;
        const auto height = std::max<std::int64_t>(
            16, image.height * width / std::max<std::int64_t>(1, image.width));
        HttpRequest request{"POST", "picture", {}, ""};
        request.body =
            fmt::format(R"({{"moment": {}, "width": {}, "height": {}}})", moment, width, height);
        HttpAnswer answer = shown_->page->answer(request);
        constexpr int drawn = 200;
        return answer.status == drawn ? std::move(answer.body) : std::string();
    }

  private:
    struct Shown {
        std::unique_ptr<ViewSubject> subject;
        std::unique_ptr<ViewPage> page;
        std::unique_ptr<HttpServer> server;  ///< ends first
    };

    std::mutex mutex_;
    Process process_;
    std::unique_ptr<Shown> shown_;
};

std::unique_ptr<ViewSubject> subject_of(std::string name, Scene scene, int threads) {
    std::vector<fs::path> files = scene_files(scene);
    return computed_subject(std::move(name), prepare_run(std::move(scene), threads),
                            std::move(files));
}

/// Of the folder of a run, results of another model, a scene's file or name, or terrain, as `fumon
/// view` takes them.
std::unique_ptr<ViewSubject> subject_of_argument(const std::string& argument,
                                                 const std::vector<std::string>& settings,
                                                 int threads) {
    if (const std::optional<fs::path> run = run_folder_of(argument)) {
        if (is_unfinished_run(*run)) return followed_subject(*run, threads, settings);
        return stored_subject(*run, threads, settings);
    }
    if (auto foreign = foreign_subject(argument, threads, settings)) return foreign;
    if (is_scene_argument(argument))
        return subject_of(argument, read_scene(scene_argument(argument), settings), threads);
    return subject_of(argument, terrain_scene(terrain_argument(argument), "", settings), threads);
}

}  // namespace

void define_views(py::module_& core) {
    py::class_<LiveView>(core, "LiveView")
        .def_static(
            "of_scene",
            [](const SceneValue& value, std::string name, int port, int threads) {
                Scene scene = value.scene();
                const py::gil_scoped_release unlocked;
                return std::make_unique<LiveView>(
                    subject_of(std::move(name), std::move(scene), threads), port, threads);
            },
            py::arg("scene"), py::arg("name"), py::arg("port"), py::arg("threads"))
        .def_static(
            "of_argument",
            [](const std::string& argument, const std::vector<std::string>& settings, int port,
               int threads) {
                const py::gil_scoped_release unlocked;
                return std::make_unique<LiveView>(subject_of_argument(argument, settings, threads),
                                                  port, threads);
            },
            py::arg("argument"), py::arg("settings"), py::arg("port"), py::arg("threads"))
        .def("close", &LiveView::close, py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("closed",
                               [](LiveView& view) {
                                   const py::gil_scoped_release unlocked;
                                   return view.closed();
                               })
        .def_property_readonly("address",
                               [](LiveView& view) {
                                   const py::gil_scoped_release unlocked;
                                   return view.address();
                               })
        .def(
            "picture",
            [](LiveView& view, int width) {
                std::string bytes;
                {
                    const py::gil_scoped_release unlocked;
                    bytes = view.picture(width);
                }
                return py::bytes(bytes);
            },
            py::arg("width"));
}

}  // namespace fumon::python
