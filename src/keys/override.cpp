#include "keys/override.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "keys/toml_text.h"

namespace fumon {

std::vector<Override> read_settings(const std::vector<std::string>& settings,
                                    const std::string& scene_place) {
    std::vector<Override> overrides;
    overrides.reserve(settings.size());
    std::vector<std::string> faults;
    for (std::size_t n = 0; n < settings.size(); ++n) {
        const std::string& text = settings[n];
        const bool in_scene = !scene_place.empty();
        const std::string place = in_scene ? scene_place : fmt::format("--set {}", n + 1);
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            faults.push_back(fmt::format(
                "{}: \"{}\" sets nothing; write key.path=VALUE, for example model.creep_rate=0.2",
                in_scene ? place : place + ":1", text));
            continue;
        }
        overrides.push_back(
            {text.substr(0, equals), text.substr(equals + 1), place, in_scene ? 0 : equals + 2});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
    return overrides;
}

std::string plain_text(const Override& override) {
    const std::string& value = override.value;
    if (value.empty() || (value.front() != '"' && value.front() != '\'')) return value;
    const auto holder = parse_toml_value(value);
    return holder ? (*holder)["value"].value_or(value) : value;
}

}  // namespace fumon
