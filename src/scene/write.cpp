#include "scene/write.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// Shortest digits that read back the same, always recognisable as a real number.
std::string real_text(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string string_text(const std::string& value) {
    std::string text = "\"";
    for (const char letter : value) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            text += '\\';
            text += letter;
        } else if (code < 0x20 || code == 0x7f) {
            text += fmt::format("\\u{:04X}", code);
        } else {
            text += letter;
        }
    }
    return text + '"';
}

struct ValueText {
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::int64_t* value) const { return fmt::format("{}", *value); }
    std::string operator()(const double* value) const { return real_text(*value); }
    std::string operator()(const std::string* value) const { return string_text(*value); }
    std::string operator()(const ChoiceTarget& target) const {
        return fmt::format("\"{}\"", target.names[static_cast<std::size_t>(target.get())].name);
    }
    std::string operator()(const WordOrRealTarget& target) const {
        return target.value->is_word() ? string_text(target.value->word)
                                       : real_text(target.value->value);
    }
    std::string operator()(const RealListTarget& target) const {
        std::vector<std::string> items;
        for (const double value : *target.values) items.push_back(real_text(value));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
    std::string operator()(const IntegerListTarget& target) const {
        return fmt::format("[{}]", fmt::join(*target.values, ", "));
    }
    std::string operator()(const TextListTarget& target) const {
        std::vector<std::string> items;
        for (const std::string& value : *target.values) items.push_back(string_text(value));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
};

/// "[camera]", or "[[overlay]]" for an item of a list of tables ("overlay.0").
std::string header(const std::string& owner) {
    const bool item = owner.find_last_not_of("0123456789") == owner.rfind('.');
    const std::string name = without_numbers(owner);
    return item ? fmt::format("\n[[{}]]\n", name) : fmt::format("\n[{}]\n", name);
}

}  // namespace

std::string value_text(const Key& key) {
    return std::visit(ValueText{}, key.target);
}

std::string to_toml(const Scene& scene) {
    Scene copy = scene;  // the table binds to writable values
    const KeyTable table = scene_keys(copy);
    std::string text;
    std::string section;
    for (const Key& key : table.keys()) {
        const std::size_t dot = key.path.rfind('.');
        const std::string owner = dot == std::string::npos ? "" : key.path.substr(0, dot);
        if (owner != section) {
            text += header(owner);
            section = owner;
        }
        text += fmt::format("{} = {}\n", key.path.substr(dot + 1), value_text(key));
    }
    return text;
}

}  // namespace fumon
