#include "scene/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "files/terrain/terrain_format.h"
#include "keys/describe_key.h"
#include "keys/keys.h"
#include "keys/look_presets.h"
#include "models/registry.h"
#include "scene/scene_keys.h"
#include "scene/view/palette_names.h"

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

constexpr std::array<Topic, 3> topics{
    {{"figure", "figure.",
      "Keys of a paper's figure, for `fumon figure`. N counts the [[figure.panel]] of a scene, "
      "and\n"
      "the [[figure.panel.curve]] and [[figure.panel.box]] of a panel, from 0"},
     {"overlay", "overlay.",
      "Keys of the overlays on the frames. N counts the [[overlay]] sections of a scene, from 0"},
     {"layer", "layer.",
      "Keys of lines, points and areas of vector files over the bed. N counts the [[layer]] "
      "sections\nof a scene, from 0"}}};

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

/// Whether a key is one that `part` names, or stands in the section that it names.
bool is_part(const std::string& path, const std::string& part) {
    const std::string plain = without_numbers(path);
    return plain == part || plain.starts_with(part + ".");
}

/// The keys of one model, or of scenes, with the values they are bound to.
struct Section {
    std::string heading;
    std::string model;  ///< empty: common to all scenes
    const Topic* topic = nullptr;
    std::string part;  ///< of a section or key alone, without numbers; empty: all
    Scene scene;
    std::any parameters;
    KeyTable table;

    [[nodiscard]] std::vector<const Key*> keys() const {
        std::vector<const Key*> all;
        for (const Key& key : table.keys()) {
            const bool wanted = part.empty() ? !model.empty() || topic_of(key.path) == topic
                                             : is_part(key.path, part);
            if (wanted) all.push_back(&key);
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

using Sections = std::vector<std::unique_ptr<Section>>;

std::unique_ptr<Section> scene_section() {
    auto section = std::make_unique<Section>();
    section->heading =
        "Keys of every scene (TOML: section.key, or key = value under [section]), each with\n"
        "what it decides (its role):\n\n" +
        describe_roles();
    fill_with_scene(*section);
    return section;
}

std::unique_ptr<Section> topic_section(const Topic& topic) {
    auto section = std::make_unique<Section>();
    section->heading = topic.heading;
    section->topic = &topic;
    fill_with_scene(*section);
    return section;
}

std::unique_ptr<Section> model_section(const ModelEntry& entry) {
    auto section = std::make_unique<Section>();
    section->model = entry.name;
    section->heading = fmt::format("Keys of the model \"{}\": {}", entry.name, entry.help);
    section->parameters = entry.default_parameters();
    fill(*section, [&] {
        KeyTable table;
        entry.list_keys(section->parameters, table);
        return table;
    });
    return section;
}

Sections all_sections() {
    Sections all;
    all.push_back(scene_section());
    for (const Topic& topic : topics) all.push_back(topic_section(topic));
    for (const ModelEntry& entry : models()) all.push_back(model_section(entry));
    return all;
}

/// The sections that hold keys of a part of a scene: "camera", "camera.azimuth",
/// "model.creep_rate", "overlay.N.corner" or "overlay.corner".
Sections sections_of_part(const std::string& part) {
    Sections found;
    const auto add = [&](std::unique_ptr<Section> section, const std::string& of_model) {
        section->part = part;
        if (section->keys().empty()) return;
        const bool one = without_numbers(section->keys().front()->path) == part;
        section->heading = (one ? part : fmt::format("Keys of [{}]", part)) + of_model;
        found.push_back(std::move(section));
    };
    add(scene_section(), "");
    for (const ModelEntry& entry : models())
        add(model_section(entry), fmt::format(" of the model \"{}\"", entry.name));
    return found;
}

/// A part as users write it, without the numbers of items: "overlay.N.corner", "edge.0.level".
std::string plain_part(std::string what) {
    for (std::size_t at = 0; (at = what.find(".N")) != std::string::npos;) what.erase(at, 2);
    return without_numbers(what);
}

Sections sections(const std::string& what) {
    Sections all;
    if (what.empty() || what == "all") return all_sections();
    if (what == "scene") {
        all.push_back(scene_section());
    } else if (const Topic* topic = find_topic(what)) {
        all.push_back(topic_section(*topic));
    } else if (const ModelEntry* entry = find_model(what)) {
        all.push_back(model_section(*entry));
    } else {
        all = sections_of_part(plain_part(what));
    }
    if (!all.empty()) return all;
    const std::vector<std::string> known = described_names();
    throw InputError(
        fmt::format("fumon describe: \"{}\" is neither a file, \"scene\", \"figure\", \"overlay\", "
                    "a model, a section nor a key; {}",
                    what,
                    nearest_name(what, known).empty() ? "`fumon describe` alone names them all"
                                                      : suggestion(what, known)));
}

/// A section's name and the keys in it, in lines of a terminal's width.
std::string summary_lines(const std::string& name, const std::vector<std::string>& keys) {
    constexpr std::size_t width = 96;
    constexpr std::size_t column = 12;
    std::string text;
    std::string line = fmt::format("  {:<{}}", name, column - 2);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string word = keys[i] + (i + 1 < keys.size() ? "," : "");
        if (line.size() + word.size() + 1 > width) {
            text += line + "\n";
            line = std::string(column, ' ');
        }
        line += (line.size() > column ? " " : line.size() < column ? "  " : "") + word;
    }
    return text + line + "\n";
}

std::vector<std::string> bed_format_names() {
    std::vector<std::string> names;
    for (const TerrainFormat& format : terrain_formats()) {
        if (format.write != nullptr) names.emplace_back(format.name);
    }
    return names;
}

}  // namespace

std::vector<std::string> described_names() {
    std::vector<std::string> names{"all", "scene"};
    for (const Topic& topic : topics) names.emplace_back(topic.name);
    for (const ModelEntry& entry : models()) names.emplace_back(entry.name);
    const auto add = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const auto& section : all_sections()) {
        for (const Key* key : section->keys()) {
            const std::string path = without_numbers(key->path);
            if (const std::size_t dot = path.rfind('.'); dot != std::string::npos)
                add(path.substr(0, dot));
            add(path);
        }
    }
    return names;
}

std::string describe_summary() {
    std::string text = "The sections of a scene and their keys:\n\n";
    const auto scene = scene_section();
    std::vector<std::pair<std::string, std::vector<std::string>>> lines;
    for (const Key* key : scene->keys()) {
        const std::string path = without_numbers(key->path);
        const std::size_t dot = path.find('.');
        const std::string name = dot == std::string::npos ? "(first)" : path.substr(0, dot);
        if (lines.empty() || lines.back().first != name) lines.push_back({name, {}});
        lines.back().second.push_back(dot == std::string::npos ? path : path.substr(dot + 1));
    }
    for (const auto& [name, keys] : lines) text += summary_lines(name, keys);
    text +=
        "  [[overlay]]  text and plots over the frames; [[layer]]: lines, points and areas of "
        "files\n";
    text += "  [figure]     a paper's figure, for `fumon figure`\n";
    text += "\nThe models, each with keys of its own under [model]:\n\n";
    for (const ModelEntry& entry : models())
        text += fmt::format("  {:<10}  {}\n", entry.name, entry.help);
    return text +
           "\n  fumon describe camera             the keys of a section, or of a model (sand): "
           "type, unit\n"
           "  fumon describe camera.azimuth     one key\n"
           "  fumon describe overlay            those of [[overlay]]; layer, figure, film and "
           "scene "
           "likewise\n"
           "  fumon describe all                every key of scenes and models\n";
}

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

std::vector<KeyWords> scene_key_words(const std::string& model) {
    std::vector<KeyWords> all;
    const auto add = [&](const Section& section) {
        for (const Key* key : section.keys()) all.push_back(key_words(*key));
    };
    add(*scene_section());
    for (KeyWords& key : all) {
        if (key.path == "look.palette") key.words = palette_names();
        if (key.path == "look.preset") key.words = look_preset_names();
        if (key.path == "output.bed_format") key.words = bed_format_names();
        if (key.path != "model.name") continue;
        for (const ModelEntry& entry : models()) key.words.emplace_back(entry.name);
    }
    for (const Topic& topic : topics) add(*topic_section(topic));
    for (const ModelEntry& entry : models()) {
        if (model.empty() || model == entry.name) add(*model_section(entry));
    }
    return all;
}

std::string models_text() {
    std::string text;
    for (const ModelEntry& entry : models())
        text += fmt::format("{:<10} {}\n", entry.name, entry.help);
    return text;
}

std::string models_json() {
    Json all = Json::array();
    for (const ModelEntry& entry : models())
        all.push_back({{"name", entry.name}, {"help", entry.help}});
    return all.dump(2) + "\n";
}

}  // namespace fumon
