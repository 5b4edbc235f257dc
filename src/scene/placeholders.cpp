#include "scene/placeholders.h"

#include <fmt/format.h>

#include "base/error.h"
#include "keys/key_value.h"
#include "keys/keys.h"
#include "keys/override.h"
#include "scene/scene_keys.h"

namespace fumon {

std::string fill_placeholders(const std::string& text, const PlaceholderValues& values,
                              const std::string& hint) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (letter != '{' && letter != '}') {
            filled += letter;
            continue;
        }
        const bool marks = i > 0 && (text[i - 1] == '^' || text[i - 1] == '_');
        if (letter == '{' && marks && text.find('}', i) != std::string::npos) {
            const std::size_t end = text.find('}', i);
            filled.append(text, i, end + 1 - i);
            i = end;
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == letter) {
            filled += letter;
            ++i;
            continue;
        }
        const std::size_t end = letter == '{' ? text.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            throw InputError(
                fmt::format("\"{}\" has an unmatched brace; write {{name}} for a value, {{{{ or "
                            "}}}} for a brace",
                            text));
        }
        const std::string name = text.substr(i + 1, end - i - 1);
        const auto value = values(name);
        if (!value) {
            throw InputError(fmt::format("{{{}}} is not a placeholder here; {}", name, hint));
        }
        filled += *value;
        i = end;
    }
    return filled;
}

std::optional<std::string> key_text(const Scene& scene, const std::string& key) {
    Scene copy = scene;  // a key table binds to what may be changed
    const KeyTable table = scene_keys(copy);
    const Key* found = table.find(key);
    if (found == nullptr) return std::nullopt;
    return plain_text({key, value_text(*found), "", 0});
}

}  // namespace fumon
