#include "scene/override.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "support/error.h"

namespace fumon {

std::vector<Override> read_settings(const std::vector<std::string>& settings) {
    std::vector<Override> overrides;
    overrides.reserve(settings.size());
    for (const std::string& text : settings) {
        const std::string place = fmt::format("--set {}", overrides.size() + 1);
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError(fmt::format(
                "{}:1: \"{}\" sets nothing; write key.path=VALUE, for example model.creep_rate=0.2",
                place, text));
        }
        overrides.push_back({text.substr(0, equals), text.substr(equals + 1), place, equals + 2});
    }
    return overrides;
}

std::string plain_text(const Override& override) {
    const std::string& value = override.value;
    if (value.empty() || (value.front() != '"' && value.front() != '\'')) return value;
    try {
        const toml::table holder = toml::parse("value = " + value);
        return holder["value"].value_or(value);
    } catch (const toml::parse_error&) {
        return value;  // no TOML: a bare string that begins with a quote
    }
}

}  // namespace fumon
