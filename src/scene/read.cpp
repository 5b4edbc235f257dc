#include "scene/read.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "keys/assign.h"
#include "keys/earlier_defaults.h"
#include "keys/look_presets.h"
#include "keys/setting.h"
#include "keys/toml_text.h"
#include "models/registry.h"
#include "scene/check.h"
#include "scene/faults.h"
#include "scene/figure/journals.h"
#include "scene/placed_sun.h"
#include "scene/scene_keys.h"
#include "scene/trust.h"
#include "scene/unknown_keys.h"

namespace fumon {

namespace {

class Reader {
  public:
    Reader(Scene& scene, std::vector<Setting> settings, std::string version, bool resolved,
           Faults& faults)
        : scene_(scene),
          settings_(std::move(settings)),
          version_(std::move(version)),
          resolved_(resolved),
          table_(scene_keys(scene)),
          faults_(faults) {}

    void read(const toml::table& root) {
        has_model_ = attempt("model.name", [&] { choose_model(root); });
        if (!has_model_) take_keys_of(terrain_model().name);
        if (faults_.attempt([&] { size_lists(root); })) {
            take_earlier_defaults(table_, version_);
            attempt("look.preset", [&] { choose_look(root); });
            read_section(root, "");
            if (resolved_) take_absent_keys();
            for (const Setting& setting : settings_) {
                if (is_known_fault(setting.given.path)) continue;
                attempt(setting.given.path, [&] { apply(setting); });
            }
            scene_.view.look.preset.clear();  // its values now stand in the keys themselves
            std::set<std::string> given;
            for (const auto& [path, place] : scene_.locations) given.insert(path);
            use_journal(scene_.figure, given);
            check_scene(scene_, faulty_, faults_);
            if (faults_.none()) check_limits(scene_, faults_);
            if (faults_.none()) place_sun(scene_.view.sun);
        }
        faults_.report();
    }

  private:
    [[nodiscard]] std::string locate(const toml::source_region& region) const {
        return fmt::format("{}:{}:{}", scene_.source, region.begin.line, region.begin.column);
    }

    /// Runs work() and keeps its fault, which is of a key or of the one that was meant.
    template <class Work>
    bool attempt(const std::string& path, const Work& work) {
        const auto section_of = [](const std::string& key) { return key.substr(0, key.find('.')); };
        const bool good = faults_.attempt([&] {
            try {
                work();
            } catch (const KeyError& fault) {
                faulty_.insert(section_of(fault.key()));
                throw;
            }
        });
        if (!good) faulty_.insert(section_of(path));
        return good;
    }

    [[nodiscard]] bool is_known_fault(std::string_view path) const {
        return path == "model.name" && !has_model_;
    }

    /// The model comes first: it decides which model.* keys there are.
    void choose_model(const toml::table& root) {
        const Key key{"model.name", {}, &scene_.model.name};
        std::string place;
        if (const auto node = root["model"]["name"]; node) {
            place = locate(node.node()->source());
            assign(key, *node.node(), [this](const auto& region) { return locate(region); });
        }
        for (const Setting& setting : settings_) {
            if (setting.given.path != "model.name") continue;
            place = setting.locate(setting.value().source());
            assign(key, setting.value(),
                   [&](const auto& region) { return setting.locate(region); });
        }
        std::vector<std::string> known;
        for (const ModelEntry& entry : models()) known.emplace_back(entry.name);
        if (place.empty() && root["figure"]["panel"]) {  // a figure may do without a model
            scene_.model.name = terrain_model().name;
            place = scene_.source;
        }
        if (place.empty()) {
            throw InputError(fmt::format(
                "{}:1:1: model.name is missing; write [model] and name = \"…\" (known: {})",
                scene_.source, fmt::join(known, ", ")));
        }
        if (find_model(scene_.model.name) == nullptr) {
            throw InputError(fmt::format("{}: unknown model \"{}\"; {} (see `fumon models`)", place,
                                         scene_.model.name, suggestion(scene_.model.name, known)));
        }
        take_keys_of(scene_.model.name);
    }

    /// A look comes before all keys that say otherwise.
    void choose_look(const toml::table& root) {
        std::string name;
        std::string place;
        if (const auto node = root["look"]["preset"]; node.is_string()) {
            name = node.value_or("");
            place = locate(node.node()->source());
        }
        for (const Setting& setting : settings_) {
            if (setting.given.path != "look.preset" || !setting.value().is_string()) continue;
            name = setting.value().value_or("");
            place = setting.locate(setting.value().source());
        }
        if (!name.empty()) apply_look_preset(table_, name, place);
    }

    void take_keys_of(std::string_view model) {
        const Scene usual = default_scene(std::string(model));
        scene_.model = usual.model;
        scene_.bed = usual.bed;
        table_ = scene_keys(scene_);
    }

    /// Gives the lists of tables as many items as file and settings have, so that the items' keys
    /// are in the table.
    void size_lists(const toml::table& root) {
        for (bool changed = true; std::exchange(changed, false);) {
            std::string within = "-";  // the list that was resized last: those within it are gone
            std::map<std::string, std::size_t> counted;
            for (const TableList& list : table_.lists()) {
                if (list.path.starts_with(within)) continue;
                const std::size_t size = size_of(list, root, counted[without_numbers(list.path)]);
                if (size == list.size()) continue;
                list.resize(size);
                within = list.path + ".";
                changed = true;
            }
            if (changed) table_ = scene_keys(scene_);
        }
    }

    /// `counted`: how many items the lists of that name have, those in other items too.
    [[nodiscard]] std::size_t size_of(const TableList& list, const toml::table& root,
                                      std::size_t& counted) const {
        std::size_t size = 0;
        if (const auto node = root.at_path(indexed(list.path)); node && node.is_array()) {
            size = node.as_array()->size();
            check_size(list, counted + size, locate(node.node()->source()));
        }
        for (const Setting& setting : settings_) {
            if (clears(setting, list.path)) size = 0;
            // One may add an item behind the last.
            if (setting.given.path.starts_with(fmt::format("{}.{}.", list.path, size))) {
                check_size(list, counted + ++size, setting.locate_key());
            }
        }
        counted += size;
        return size;
    }

    /// Whether a setting is that of a whole list, which takes "[]" alone.
    static bool clears(const Setting& setting, const std::string& list) {
        const toml::array* items = setting.value().as_array();
        return setting.given.path == list && items != nullptr && items->empty();
    }

    [[nodiscard]] bool is_cleared(const std::string& list) const {
        return std::ranges::any_of(settings_,
                                   [&](const Setting& setting) { return clears(setting, list); });
    }

    static void check_size(const TableList& list, std::size_t size, const std::string& place) {
        if (size <= most_tables) return;
        throw InputError(fmt::format("{}: [[{}]] occurs more than {} times", place,
                                     without_numbers(list.path), most_tables));
    }

    /// "figure.panel.0.curve" as the TOML reader's paths have it: "figure.panel[0].curve".
    static std::string indexed(const std::string& path) {
        std::string text;
        for (std::size_t start = 0; start <= path.size();) {
            const std::size_t end = std::min(path.find('.', start), path.size());
            const std::string part = path.substr(start, end - start);
            const bool number = part.find_first_not_of("0123456789") == std::string::npos;
            text += number ? "[" + part + "]" : (text.empty() ? "" : ".") + part;
            start = end + 1;
        }
        return text;
    }

    /// The items of a list of tables.
    void read_items(const toml::array& items, const std::string& path) {
        std::size_t index = 0;
        for (const toml::node& item : items) {
            const std::string prefix = fmt::format("{}.{}.", path, index++);
            if (item.is_table()) {
                read_section(*item.as_table(), prefix);
                continue;
            }
            attempt(path, [&] {
                throw InputError(
                    fmt::format("{}: {} is a list of sections; write [[{}]] and its "
                                "keys below",
                                locate(item.source()), path, without_numbers(path)));
            });
        }
    }

    void read_section(const toml::table& section, const std::string& prefix) {
        for (const auto& [name, value] : section) {
            const std::string path = prefix + std::string(name.str());
            const std::string place = locate(name.source());
            if (const Key* key = table_.find(path)) {
                if (is_known_fault(path)) continue;
                attempt(path, [&, &value = value] { read_value(*key, value, place); });
                scene_.locations[path] = locate(value.source());
            } else if (value.is_array() && table_.find_list(path) != nullptr) {
                if (!is_cleared(path)) read_items(*value.as_array(), path);
            } else if (value.is_table() && is_section(table_, path) &&
                       table_.find_list(path) == nullptr) {
                read_section(*value.as_table(), path + ".");
            } else {
                attempt(path, [&] { refuse_unknown(path, place); });
            }
        }
    }

    /// Whether a key is of an item of a list, of which the text says nothing: settings add it.
    [[nodiscard]] bool is_of_added_item(const std::string& path) const {
        if (without_numbers(path) == path) return false;
        const std::string item = path.substr(0, path.rfind('.') + 1);
        const auto said = scene_.locations.lower_bound(item);
        return said == scene_.locations.end() || !said->first.starts_with(item);
    }

    /// Keys that came, within one version, after the text was kept.
    void take_absent_keys() const {
        for (const Key& key : table_.keys()) {
            const bool had = is_earlier_version(version_, key.notes.earlier.until);
            if (had || scene_.locations.contains(key.path) || is_of_added_item(key.path)) continue;
            take_default_of_absence(key);
        }
    }

    void read_value(const Key& key, const toml::node& value, const std::string& place) {
        if (value.is_table()) {
            throw InputError(fmt::format("{}: {} is not a section; it takes {}", place, key.path,
                                         accepted_values(key)));
        }
        if (is_earlier_version(version_, key.notes.earlier.until) &&
            value.value<std::string_view>() == "auto")
            return;  // it has that value
        assign(key, value, [this](const auto& region) { return locate(region); });
    }

    void apply(const Setting& setting) {
        const auto locate_value = [&](const toml::source_region& region) {
            return setting.locate(region);
        };
        if (const Key* key = table_.find(setting.given.path)) {
            assign(*key, setting.value(), locate_value);
        } else if (const auto item = list_item(setting.given.path)) {
            assign_item(*item->first, item->second, setting.value(), locate_value);
        } else if (table_.find_list(setting.given.path) != nullptr) {
            if (clears(setting, setting.given.path)) return;
            throw InputError(fmt::format(
                "{}: {} is a list of sections: {}=[] clears it, and {}.0.KEY=VALUE sets a key of "
                "its first",
                setting.locate_key(), setting.given.path, setting.given.path, setting.given.path));
        } else {
            refuse_unknown(setting.given.path, setting.locate_key());
        }
        scene_.locations[setting.given.path] = setting.locate(setting.value().source());
    }

    /// "frames.at.0" → the key frames.at and 0.
    [[nodiscard]] std::optional<std::pair<const Key*, std::size_t>> list_item(
        const std::string& path) const {
        const std::size_t dot = path.rfind('.');
        if (dot == std::string::npos || dot + 1 == path.size()) return std::nullopt;
        std::size_t index = 0;
        const char* end = path.data() + path.size();
        const auto [stop, fault] = std::from_chars(path.data() + dot + 1, end, index);
        const Key* key = table_.find(path.substr(0, dot));
        if (fault != std::errc{} || stop != end || key == nullptr) return std::nullopt;
        return std::pair{key, index};
    }

    /// A model's keys are known only where the model is.
    void refuse_unknown(const std::string& path, const std::string& place) const {
        if (!has_model_ && path.starts_with("model.")) return;
        refuse_unknown_key(path, place, table_, has_model_ ? scene_.model.name : "");
    }

    Scene& scene_;
    std::vector<Setting> settings_;
    std::string version_;  ///< whose defaults hold
    bool resolved_;        ///< the text says all keys of then
    KeyTable table_;
    Faults& faults_;
    std::set<std::string> faulty_;  ///< sections with a fault
    bool has_model_ = false;
};

}  // namespace

Scene parse_scene(const SceneText& scene_text, const std::vector<Override>& overrides) {
    Scene scene;
    scene.source = scene_text.source;
    scene.directory = scene_text.directory;
    scene.trusted = scene_text.trusted;
    scene.bed_hashes = scene_text.bed_hashes;
    std::vector<Setting> settings;
    settings.reserve(overrides.size());
    Faults faults(scene.source);
    for (const Override& override : overrides)
        faults.attempt([&] { settings.push_back(parse_setting(override)); });
    const toml::table root = parse_toml(scene_text.text, scene.source,
                                        "a scene is TOML: [section] lines and key = value lines");
    if (!root.contains("model") && (root.contains("shot") || root.contains("film"))) {
        throw InputError(
            fmt::format("{}: is a film, not a scene; a film is cut from a run: fumon film RUN {}",
                        scene.source, scene.source));
    }
    Reader(scene, std::move(settings), scene_text.version, scene_text.resolved, faults).read(root);
    return scene;
}

Scene parse_scene(std::string_view text, const std::string& source,
                  const std::filesystem::path& directory,
                  const std::vector<std::string>& settings) {
    return parse_scene({std::string(text), source, directory}, read_settings(settings));
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    return parse_scene(read_scene_text(file), read_settings(settings));
}

}  // namespace fumon
