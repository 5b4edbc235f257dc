#include "scene/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "keys/keys.h"
#include "models/registry.h"
#include "scene/scene_keys.h"
#include "scene/write.h"

namespace fumon {

namespace {

/// The keys that only figures and overlays have are many: they are told apart from those of every
/// scene.
struct Topic {
    std::string_view name;
    std::string_view prefix;  ///< of its keys' paths
    std::string_view heading;
};

constexpr std::array<Topic, 2> topics{
    {{"figure", "figure.",
      "Keys of a paper's figure, for `fumon figure`. N counts the [[figure.panel]] of a scene, "
      "and\n"
      "the [[figure.panel.curve]] and [[figure.panel.box]] of a panel, from 0"},
     {"overlay", "overlay.",
      "Keys of what stands over the frames. N counts the [[overlay]] of a scene, from 0"}}};

const Topic* topic_of(const std::string& path) {
    for (const Topic& topic : topics) {
        if (path.starts_with(topic.prefix)) return &topic;
    }
    return nullptr;
}

const Topic* find_topic(const std::string& name) {
    for (const Topic& topic : topics) {
        if (name == topic.name) return &topic;
    }
    return nullptr;
}

/// The keys of one model, or of scenes, with the values they are bound to.
struct Section {
    std::string heading;
    std::string model;  ///< empty: common to all scenes
    const Topic* topic = nullptr;
    Scene scene;
    std::any parameters;
    KeyTable table;

    [[nodiscard]] std::vector<const Key*> keys() const {
        std::vector<const Key*> all;
        for (const Key& key : table.keys()) {
            if (!model.empty() || topic_of(key.path) == topic) all.push_back(&key);
        }
        return all;
    }
};

/// A scene's keys with one item in each list of tables.
void fill(Section& section) {
    section.table = scene_keys(section.scene);
    for (bool changed = true; std::exchange(changed, false);) {
        for (const TableList& list : section.table.lists()) {
            if (list.size() > 0) continue;
            list.resize(1);
            section.table = scene_keys(section.scene);
            changed = true;
            break;
        }
    }
}

/// "overlay.0.corner" as "overlay.N.corner".
std::string general_path(std::string path) {
    for (std::size_t at = 0; (at = path.find(".0.")) != std::string::npos;) path[at + 1] = 'N';
    return path;
}

void check_name(const std::string& what) {
    if (what.empty() || what == "scene" || find_topic(what) != nullptr ||
        find_model(what) != nullptr)
        return;
    std::vector<std::string> known{"scene"};
    for (const Topic& topic : topics) known.emplace_back(topic.name);
    for (const ModelEntry& entry : models()) known.emplace_back(entry.name);
    throw InputError(fmt::format(
        "fumon describe: \"{}\" is neither \"scene\", \"figure\", \"overlay\" nor a model; {}",
        what, suggestion(what, known)));
}

std::vector<std::unique_ptr<Section>> sections(const std::string& what) {
    check_name(what);
    std::vector<std::unique_ptr<Section>> all;
    if (what.empty() || what == "scene") {
        auto section = std::make_unique<Section>();
        section->heading =
            "Keys of every scene (TOML: section.key, or key = value under [section])";
        fill(*section);
        all.push_back(std::move(section));
    }
    for (const Topic& topic : topics) {
        if (!what.empty() && what != topic.name) continue;
        auto section = std::make_unique<Section>();
        section->heading = topic.heading;
        section->topic = &topic;
        fill(*section);
        all.push_back(std::move(section));
    }
    for (const ModelEntry& entry : models()) {
        if (!what.empty() && what != entry.name) continue;
        auto section = std::make_unique<Section>();
        section->model = entry.name;
        section->heading = fmt::format("Keys of the model \"{}\": {}", entry.name, entry.help);
        section->parameters = entry.default_parameters();
        entry.list_keys(section->parameters, section->table);
        all.push_back(std::move(section));
    }
    return all;
}

std::string type_text(const Key& key) {
    struct Name {
        std::string operator()(const bool*) const { return "true or false"; }
        std::string operator()(const std::int64_t*) const { return "whole number"; }
        std::string operator()(const double*) const { return "number"; }
        std::string operator()(const std::string*) const { return "text"; }
        std::string operator()(const ChoiceTarget&) const { return "choice"; }
        std::string operator()(const WordOrRealTarget&) const { return "word or number"; }
        std::string operator()(const RealListTarget&) const { return "list of numbers"; }
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

const std::vector<ChoiceName>& words_of(const Key& key) {
    static const std::vector<ChoiceName> none;
    if (const auto* choice = std::get_if<ChoiceTarget>(&key.target)) return choice->names;
    if (const auto* either = std::get_if<WordOrRealTarget>(&key.target)) return either->words;
    return none;
}

bool required(const Key& key) {
    return key.path == "model.name" || key.path == "run.steps";
}

std::string key_text(const Key& key) {
    std::string facts = type_text(key);
    if (!key.notes.unit.empty()) facts += ", " + key.notes.unit;
    if (takes_numbers(key) && key.notes.range.text() != "any")
        facts += ", " + key.notes.range.text();
    const std::string standard = required(key) ? "required" : "default " + value_text(key);
    std::string text = fmt::format("  {:<28} {} [{}]\n      {}\n", general_path(key.path), facts,
                                   standard, key.notes.help);
    for (const ChoiceName& word : words_of(key))
        text += fmt::format("        {:<18} {}\n", word.name, word.help);
    return text;
}

nlohmann::ordered_json key_json(const Key& key, const std::string& model) {
    nlohmann::ordered_json json;
    json["key"] = general_path(key.path);
    json["type"] = type_text(key);
    json["unit"] = key.notes.unit;
    json["default"] =
        required(key) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value_text(key));
    json["required"] = required(key);
    if (takes_numbers(key)) {
        const Range& range = key.notes.range;
        json["minimum"] = std::isfinite(range.low) ? nlohmann::ordered_json(range.low) : nullptr;
        json["minimum_excluded"] = range.low_open;
        json["maximum"] = std::isfinite(range.high) ? nlohmann::ordered_json(range.high) : nullptr;
    }
    nlohmann::ordered_json words = nlohmann::ordered_json::array();
    for (const ChoiceName& word : words_of(key))
        words.push_back({{"name", word.name}, {"help", word.help}});
    if (!words.empty()) json["values"] = words;
    json["model"] = model.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(model);
    json["help"] = key.notes.help;
    return json;
}

}  // namespace

std::string describe_text(const std::string& what) {
    std::string text;
    for (const auto& section : sections(what)) {
        if (!text.empty()) text += "\n";
        text += section->heading + "\n\n";
        if (section->keys().empty()) text += "  none\n";
        for (const Key* key : section->keys()) text += key_text(*key);
    }
    return text;
}

std::string describe_json(const std::string& what) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& section : sections(what)) {
        for (const Key* key : section->keys()) all.push_back(key_json(*key, section->model));
    }
    return all.dump(2) + "\n";
}

std::string models_text() {
    std::string text;
    for (const ModelEntry& entry : models())
        text += fmt::format("{:<10} {}\n", entry.name, entry.help);
    return text;
}

}  // namespace fumon
