#include "keys/override.h"

#include <fmt/format.h>

#include "base/error.h"
#include "keys/toml_text.h"

namespace fumon {

std::vector<Override> read_settings(const std::vector<std::string>& settings,
                                    const std::string& scene_place) {
    std::vector<Override> overrides;
    overrides.reserve(settings.size());
    for (const std::string& text : settings) {
        const bool in_scene = !scene_place.empty();
        const std::string place =
            in_scene ? scene_place : fmt::format("--set {}", overrides.size() + 1);
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError(fmt::format(
                "{}: \"{}\" sets nothing; write key.path=VALUE, for example model.creep_rate=0.2",
                in_scene ? place : place + ":1", text));
        }
        overrides.push_back(
            {text.substr(0, equals), text.substr(equals + 1), place, in_scene ? 0 : equals + 2});
    }
    return overrides;
}

std::string plain_text(const Override& override) {
    const std::string& value = override.value;
    if (value.empty() || (value.front() != '"' && value.front() != '\'')) return value;
    const auto holder = parse_toml_value(value);
    return holder ? (*holder)["value"].value_or(value) : value;
}

}  // namespace fumon
