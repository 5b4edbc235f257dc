#include "keys/describe_key.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "keys/key_value.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

/// "overlay.0.corner" as "overlay.N.corner".
std::string general_path(std::string path) {
    for (std::size_t at = 0; (at = path.find(".0.")) != std::string::npos;) path[at + 1] = 'N';
    return path;
}

std::string type_text(const Key& key) {
    struct Name {
        std::string operator()(const bool*) const { return "true or false"; }
        std::string operator()(const std::int64_t*) const { return "whole number"; }
        std::string operator()(const double*) const { return "number"; }
        std::string operator()(const std::string*) const { return "text"; }
        std::string operator()(const ChoiceTarget&) const { return "choice"; }
        std::string operator()(const WordOrRealTarget&) const { return "word or number"; }
        std::string operator()(const RealListTarget& target) const {
            return target.words.empty() ? "list of numbers" : "word or list of numbers";
        }
        std::string operator()(const IntegerListTarget&) const { return "list of whole numbers"; }
        std::string operator()(const TextListTarget&) const { return "list of texts"; }
    };
    return std::visit(Name{}, key.target);
}

bool takes_numbers(const Key& key) {
    return !std::holds_alternative<bool*>(key.target) &&
           !std::holds_alternative<std::string*>(key.target) &&
           !std::holds_alternative<TextListTarget>(key.target) &&
           !std::holds_alternative<ChoiceTarget>(key.target);
}

const std::vector<KeyWord>& words_of(const Key& key) {
    static const std::vector<KeyWord> none;
    if (const auto* choice = std::get_if<ChoiceTarget>(&key.target)) return choice->words;
    if (const auto* either = std::get_if<WordOrRealTarget>(&key.target)) return either->words;
    if (const auto* list = std::get_if<RealListTarget>(&key.target)) return list->words;
    return none;
}

const std::vector<WordForm>& forms_of(const Key& key) {
    static const std::vector<WordForm> none;
    const auto* either = std::get_if<WordOrRealTarget>(&key.target);
    return either == nullptr ? none : either->forms;
}

}  // namespace

std::string describe_key(const Key& key) {
    std::string facts = type_text(key);
    if (!key.notes.unit.empty()) facts += ", " + key.notes.unit;
    if (takes_numbers(key) && key.notes.range.text() != "any")
        facts += ", " + key.notes.range.text();
    const std::string standard = key.notes.required ? "required" : "default " + value_text(key);
    std::string text = fmt::format("  {:<28} {} [{}] ({})\n      {}\n", general_path(key.path),
                                   facts, standard, role_name(key.role), key.notes.help);
    for (const KeyWord& known : words_of(key))
        text += fmt::format("        {:<18} {}\n", known.word, known.help);
    for (const WordForm& form : forms_of(key))
        text += fmt::format("        {:<18} {}\n", form.example, form.help);
    return text;
}

nlohmann::ordered_json key_json(const Key& key) {
    Json json;
    json["key"] = general_path(key.path);
    json["type"] = type_text(key);
    json["unit"] = key.notes.unit;
    json["default"] = key.notes.required ? Json(nullptr) : Json(value_text(key));
    json["required"] = key.notes.required;
    if (takes_numbers(key)) {
        const Range& range = key.notes.range;
        json["minimum"] = std::isfinite(range.low) ? Json(range.low) : nullptr;
        json["minimum_excluded"] = range.low_open;
        json["maximum"] = std::isfinite(range.high) ? Json(range.high) : nullptr;
    }
    Json words = Json::array();
    for (const KeyWord& known : words_of(key))
        words.push_back({{"name", known.word}, {"help", known.help}});
    for (const WordForm& form : forms_of(key))
        words.push_back({{"example", form.example}, {"help", form.help}});
    if (!words.empty()) json["values"] = words;
    json["role"] = role_name(key.role);
    json["help"] = key.notes.help;
    return json;
}

KeyWords key_words(const Key& key) {
    KeyWords words{key.path, key.notes.help, {}};
    for (const KeyWord& known : words_of(key)) words.words.emplace_back(known.word);
    if (std::holds_alternative<bool*>(key.target)) words.words = {"true", "false"};
    return words;
}

std::string describe_roles() {
    std::string text;
    for (const KeyRoleText& role : key_roles())
        text += fmt::format("  {:<10} {}\n", role.name, role.help);
    return text;
}

}  // namespace fumon
