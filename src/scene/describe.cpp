#include "scene/describe.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "keys/describe_key.h"
#include "keys/keys.h"
#include "models/registry.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

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
      "Keys of the overlays on the frames. N counts the [[overlay]] sections of a scene, from 0"}}};

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

/// The keys that `list_keys` gives, with one item in each list of tables.
template <class ListKeys>
void fill(Section& section, const ListKeys& list_keys) {
    section.table = list_keys();
    for (bool changed = true; std::exchange(changed, false);) {
        for (const TableList& list : section.table.lists()) {
            if (list.size() > 0) continue;
            list.resize(1);
            section.table = list_keys();
            changed = true;
            break;
        }
    }
}

void fill_with_scene(Section& section) {
    fill(section, [&] { return scene_keys(section.scene); });
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
            "Keys of every scene (TOML: section.key, or key = value under [section]), each with\n"
            "what it decides (its role):\n\n" +
            describe_roles();
        fill_with_scene(*section);
        all.push_back(std::move(section));
    }
    for (const Topic& topic : topics) {
        if (!what.empty() && what != topic.name) continue;
        auto section = std::make_unique<Section>();
        section->heading = topic.heading;
        section->topic = &topic;
        fill_with_scene(*section);
        all.push_back(std::move(section));
    }
    for (const ModelEntry& entry : models()) {
        if (!what.empty() && what != entry.name) continue;
        auto section = std::make_unique<Section>();
        section->model = entry.name;
        section->heading = fmt::format("Keys of the model \"{}\": {}", entry.name, entry.help);
        section->parameters = entry.default_parameters();
        fill(*section, [&] {
            KeyTable table;
            entry.list_keys(section->parameters, table);
            return table;
        });
        all.push_back(std::move(section));
    }
    return all;
}

}  // namespace

std::string describe_text(const std::string& what) {
    std::string text;
    for (const auto& section : sections(what)) {
        if (!text.empty()) text += "\n";
        text += section->heading + "\n\n";
        if (section->keys().empty()) text += "  none\n";
        for (const Key* key : section->keys()) text += describe_key(*key);
    }
    return text;
}

std::string describe_json(const std::string& what) {
    Json all = Json::array();
    for (const auto& section : sections(what)) {
        for (const Key* key : section->keys()) {
            all.push_back(key_json(*key));
            all.back()["model"] = section->model.empty() ? Json(nullptr) : Json(section->model);
        }
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
