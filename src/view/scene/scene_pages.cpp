#include "view/scene/scene_pages.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "scene/faults.h"
#include "scene/json.h"
#include "scene/trust.h"
#include "view/page_request.h"
#include "view/picture/look_changes.h"
#include "view/subject/computed_subject.h"
#include "view/view_page.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_other_computations = 2;

/// Takes the settings of the model out of a request's body, sorted.
std::vector<std::string> take_model_settings(Json& body) {
    std::vector<std::string> of_model;
    std::vector<std::string> others;
    for (std::string& setting : settings_in(body)) {
        const bool model = is_model_key(std::string_view(setting).substr(0, setting.find('=')));
        (model ? of_model : others).push_back(std::move(setting));
    }
    std::ranges::sort(of_model);
    if (!of_model.empty()) body["settings"] = others;
    return of_model;
}

}  // namespace

ScenePages::ScenePages(std::string name, PreparedRun run, std::vector<std::filesystem::path> files,
                       ReadScene read, ViewOptions options)
    : name_(std::move(name)),
      files_(std::move(files)),
      read_(std::move(read)),
      options_(std::move(options)) {
    options_.computes = true;
    own_ = computed(std::move(run));
}

std::shared_ptr<Pages> ScenePages::computed(PreparedRun run) const {
    return std::make_shared<SubjectPages>(computed_subject(name_, std::move(run), files_),
                                          options_);
}

HttpAnswer ScenePages::answer(const HttpRequest& request) {
    if (request.method != "POST") return own_->answer(request);
    Json body = body_json(request);
    const std::vector<std::string> settings = take_model_settings(body);
    if (settings.empty()) return own_->answer(request);
    HttpRequest rest = request;
    rest.body = body.dump(-1, ' ', false, Json::error_handler_t::replace);
    try {
        return pages_of(settings)->answer(rest);
    } catch (const InputError& fault) {
        if (request.path != "check") throw;
        HttpAnswer answer;
        answer.type = "application/json";
        answer.body = json_text({{"fault", fault.what()}});
        return answer;
    }
}

Scene ScenePages::scene_with(const std::vector<std::string>& settings) const {
    Scene scene = read_(settings);
    if (options_.trust) return scene;
    Scene own = read_({});
    Scene asked = scene;
    own.trusted = false;
    asked.trusted = false;
    Faults before(own.source);
    check_limits(own, before);
    if (!before.none()) return scene;  // the user's own scene is beyond them
    Faults faults(asked.source);
    check_limits(asked, faults);
    faults.report();
    return scene;
}

std::shared_ptr<Pages> ScenePages::pages_of(const std::vector<std::string>& settings) {
    std::list<Computed> closed;  // which ends what it computes, after the lock
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find(others_, settings, &Computed::settings);
    if (known != others_.end()) {
        others_.splice(others_.begin(), others_, known);
        return others_.front().pages;
    }
    std::shared_ptr<Pages> pages =
        computed(prepare_run(scene_with(settings), options_.work.threads));
    if (others_.size() >= most_other_computations) {
        others_.back().pages->cancel_all();
        closed.splice(closed.begin(), others_, std::prev(others_.end()));
    }
    if (cancelled_) pages->cancel_all();
    others_.push_front({settings, pages});
    return pages;
}

void ScenePages::cancel_all() {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    own_->cancel_all();
    for (const Computed& other : others_) other.pages->cancel_all();
}

}  // namespace fumon
