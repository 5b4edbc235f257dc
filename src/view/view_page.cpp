#include "view/view_page.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "outputs/output_claims.h"
#include "scene/json.h"
#include "view/page_files.h"
#include "view/page_film.h"
#include "view/page_request.h"
#include "view/page_saving.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* fixed_model =
    "the run was computed with this value; fumon view SCENE computes with others";
constexpr const char* json_type = "application/json";
constexpr std::size_t most_plotted_rows = 2000;
constexpr int not_found = 404;
constexpr int accepted = 202;
constexpr int no_content = 204;
constexpr int conflict = 409;
constexpr int too_many_requests = 429;
constexpr std::array<std::string_view, 6> still_endings{".png",  ".jpg", ".jpeg",
                                                        ".webp", ".tif", ".tiff"};

HttpAnswer json_answer(const Json& json) {
    HttpAnswer answer;
    answer.type = json_type;
    answer.body = json_text(json);
    return answer;
}

Json moments_json(const std::vector<ShownMoment>& moments) {
    Json list = Json::array();
    for (const ShownMoment& moment : moments)
        list.push_back({{"step", moment.step}, {"time", moment.time}, {"ready", moment.ready}});
    return list;
}

std::string name_in(const Json& asked, const char* usual) {
    return asked.contains("name") && asked["name"].is_string() ? asked["name"].get<std::string>()
                                                               : usual;
}

}  // namespace

ViewPage::ViewPage(ViewSubject& subject, ViewOptions options)
    : subject_(subject),
      options_(std::move(options)),
      changes_(subject.scene(), subject.first(), options_.trust),
      pictures_(subject, changes_, options_.work) {}

HttpAnswer ViewPage::answer(const HttpRequest& request) {
    const std::string& path = request.path;
    if (request.method == "GET") {
        if (path == "subject") return subject_answer();
        if (path == "progress") return progress_answer();
        if (path == "measurements") return measurements_answer();
        if (path == "presets") return json_answer(changes_.presets());
        if (const auto file = page_file(path)) return *file;
    } else {
        if (path == "picture") return picture_answer(request);
        if (path == "camera") return camera_answer(request);
        if (path == "still") return still_answer(request);
        if (path == "scene") return scene_answer(request);
        if (path == "film") return film_answer(request);
        if (path == "check") return check_answer(request);
        if (path == "progress") return progress_answer();
        if (path == "measurements") return measurements_answer();
    }
    return plain_answer(not_found, "no such page");
}

HttpAnswer ViewPage::subject_answer() const {
    const Scene& scene = subject_.scene();
    const Snapshot& first = subject_.first();
    const ImageSettings& image = scene.view.image;
    Json json;
    json["fumon"] = FUMON_VERSION;
    json["name"] = subject_.name();
    json["title"] = scene.title;
    json["model"] = scene.model.name;
    json["time_unit"] = first.time_unit;
    json["grid"] = {{"nx", first.bed.nx()},
                    {"ny", first.bed.ny()},
                    {"dx", first.scale.dx},
                    {"dy", first.scale.dy},
                    {"unit", first.scale.in_metres ? "m" : "sites"}};
    json["image"] = {{"width", image.width}, {"height", image.height}};
    json["flat"] = first.section && scene.view.look.mode == ViewMode::figure;
    json["saves"] = !options_.save.empty();
    json["folder"] = options_.save.string();
    json["job"] = options_.watch != nullptr;
    json["state"] = subject_.work().state;
    json["moments"] = moments_json(subject_.moments());
    json["drops"] = options_.drops;
    json["computes"] = options_.computes;
    json["keys"] = changes_.keys(options_.computes ? "" : fixed_model);
    json["further_overlay"] = changes_.keys_of_further_overlay();
    return json_answer(json);
}

HttpAnswer ViewPage::progress_answer() const {
    const ViewWork work = subject_.work();
    Json json;
    json["state"] = work.state;
    json["step"] = work.step;
    json["target"] = work.target;
    json["cell_steps_per_second"] = work.cell_steps_per_second;
    json["fault"] = work.fault;
    json["follow"] = options_.watch == nullptr || options_.watch->may_draw();
    json["moments"] = moments_json(subject_.moments());
    return json_answer(json);
}

HttpAnswer ViewPage::measurements_answer() const {
    Json list = Json::array();
    for (const ViewColumn& column : subject_.measurements()) {
        Json values = Json::array();
        const std::size_t rows = column.values.size();
        const std::size_t stride = rows / most_plotted_rows + 1;
        for (std::size_t i = 0; i < rows; ++i) {
            if (i % stride != 0 && i + 1 != rows) continue;
            const double value = column.values[i];
            values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
        }
        list.push_back({{"name", column.name}, {"unit", column.unit}, {"values", values}});
    }
    return json_answer(list);
}

HttpAnswer ViewPage::picture_answer(const HttpRequest& request) {
    DrawnPicture picture = pictures_.draw(picture_request_in(body_json(request)));
    switch (picture.outcome) {
        case RequestOutcome::superseded:
            return plain_answer(no_content, {});  // a newer one is asked for
        case RequestOutcome::too_many:
            return plain_answer(too_many_requests, "too many pictures are wanted");
        case RequestOutcome::computing:
            return plain_answer(accepted, "it is being computed");
        case RequestOutcome::drawn:
            break;
    }
    if (options_.watch != nullptr) options_.watch->spend(picture.seconds);
    HttpAnswer answer;
    answer.type = picture.type;
    answer.body = std::move(picture.bytes);
    answer.headers["X-Fumon-Step"] = std::to_string(picture.step);
    answer.headers["X-Fumon-Seconds"] = fmt::format("{:.4f}", picture.seconds);
    if (!picture.camera.empty()) answer.headers["X-Fumon-Camera"] = json_text(picture.camera);
    return answer;
}

HttpAnswer ViewPage::camera_answer(const HttpRequest& request) const {
    const ViewRequest wanted = picture_request_in(body_json(request));
    const std::shared_ptr<const Snapshot> snapshot = subject_.snapshot(wanted.moment);
    if (!snapshot) return plain_answer(accepted, "it is being computed");
    const PictureThread::Settled settled = pictures_.settled(wanted, *snapshot);
    const CameraFacts facts = camera_facts(settled.scene, subject_.first(), *snapshot);
    return json_answer({{"eye", facts.place.eye},
                        {"target", facts.place.target},
                        {"azimuth", facts.azimuth},
                        {"elevation", facts.elevation},
                        {"distance", facts.distance},
                        {"side", facts.side},
                        {"tangent", facts.tangent},
                        {"settings", settled.camera}});
}

HttpAnswer ViewPage::check_answer(const HttpRequest& request) const {
    const std::vector<std::string> settings = settings_in(body_json(request));
    try {
        static_cast<void>(changes_.with(settings));
    } catch (const InputError& fault) {
        return json_answer({{"fault", fault.what()}});
    }
    return json_answer(Json::object());
}

HttpAnswer ViewPage::still_answer(const HttpRequest& request) {
    const Json asked = body_json(request);
    const std::string name = saved_name(name_in(asked, "still.png"), still_endings);
    ViewRequest wanted = picture_request_in(asked);
    wanted.client += " saves";
    wanted.draft = false;
    wanted.ending = small_ending(name);
    DrawnPicture picture = pictures_.draw(std::move(wanted));
    if (picture.outcome != RequestOutcome::drawn)
        return plain_answer(conflict, "the picture is not there yet; try again");
    return saved(options_, subject_, name, picture.type, std::move(picture.bytes));
}

HttpAnswer ViewPage::scene_answer(const HttpRequest& request) const {
    const Json asked = body_json(request);
    const std::string name = saved_name(name_in(asked, "scene.toml"), scene_ending);
    return saved(options_, subject_, name, "application/toml",
                 changes_.scene_file(settings_in(asked)));
}

HttpAnswer ViewPage::film_answer(const HttpRequest& request) const {
    const Json asked = body_json(request);
    const std::string name = saved_name(name_in(asked, "film.toml"), scene_ending);
    return saved(options_, subject_, name, "application/toml",
                 film_file_of(asked, subject_, changes_));
}

}  // namespace fumon
