#include "view/page_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.h"
#include "files/json_text.h"
#include "film/film_read.h"
#include "film/script/film_looks.h"
#include "keys/override.h"
#include "outputs/own_file.h"
#include "view/page_request.h"
#include "view/picture/camera_pose.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

/// Settings of a film, those of a scene that it may have, too.
std::vector<std::string> looks_in(const std::vector<std::string>& settings) {
    const std::vector<std::string>& sections = film_look_sections();
    std::vector<std::string> looks;
    for (const std::string& setting : settings) {
        const std::string section = setting.substr(0, setting.find('.'));
        if (section == "camera") continue;  // its shots say where that stands
        if (std::ranges::find(sections, section) != sections.end()) looks.push_back(setting);
    }
    return looks;
}

std::string key_text(const Json& key, ViewSubject& subject, const Scene& scene) {
    std::string text = "\n[[shot.key]]\n";
    // A film's places count from the first bed's ground.
    for (const std::string& setting :
         settings_of(place_in(key), scene, subject.first(), subject.first())) {
        const std::size_t at = setting.find('=');
        const std::string name = setting.substr(0, at);
        if (name == "camera.framing") continue;
        text += fmt::format("{} = {}\n", name.substr(name.find('.') + 1), setting.substr(at + 1));
    }
    return text;
}

}  // namespace

std::string film_file_of(const Json& asked, ViewSubject& subject, const LookChanges& changes) {
    constexpr std::size_t most = 100;
    const std::vector<std::string> settings = settings_in(asked);
    const Scene scene = changes.with(settings);
    const std::vector<ShownMoment> moments = subject.moments();
    std::string text;
    try {
        const Json& shots = asked.at("shots");
        if (!shots.is_array() || shots.empty()) throw InputError("a film has at least one shot");
        if (shots.size() > most) throw InputError(fmt::format("a film has at most {} shots", most));
        for (const Json& shot : shots) {
            const Json& keys = shot.at("keys");
            if (!keys.is_array() || keys.empty())
                throw InputError("a shot has at least one place of the camera");
            if (keys.size() > most)
                throw InputError(fmt::format("a shot has at most {} places", most));
            const auto step_of = [&](const Json& key) {
                // Its step, for the moments of a run that goes on are numbered anew.
                const std::int64_t step = whole_number(key.at("step"));
                if (std::ranges::find(moments, step, &ShownMoment::step) == moments.end())
                    throw InputError(fmt::format("the run has no bed of step {} for a shot", step));
                return step;
            };
            text += fmt::format("\n[[shot]]\nseconds = {}\nfrom = {}\nto = {}\nmove = \"{}\"\n",
                                shot.at("seconds").get<double>(), step_of(keys.front()),
                                step_of(keys.back()), keys.size() > 1 ? "keys" : "still");
            for (const Json& key : keys) text += key_text(key, subject, scene);
        }
    } catch (const nlohmann::json::exception& fault) {
        throw InputError(
            fmt::format("a film that no page of this fumon asks for: {}", fault.what()));
    }
    const Film film = parse_film(text, "the film", looks_in(settings), false);
    return fmt::format("{}{} from the window of `fumon view`.\n{}", own_scene_mark, FUMON_VERSION,
                       film_toml(film));
}

}  // namespace fumon
