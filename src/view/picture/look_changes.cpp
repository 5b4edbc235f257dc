#include "view/picture/look_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "keys/describe_key.h"
#include "keys/key_value.h"
#include "keys/keys.h"
#include "keys/look_presets.h"
#include "keys/override.h"
#include "outputs/own_file.h"
#include "render/colour/palette.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "scene/scene_keys.h"
#include "scene/trust.h"
#include "scene/write.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> sections{"camera",  "sun",       "air",   "look",
                                                   "section", "streamers", "image", "overlay"};
/// Of which the page knows no file, and which decide no picture on a screen.
constexpr std::array<std::string_view, 6> left_out{"look.drape",     "image.words",
                                                   "image.language", "image.quality",
                                                   "image.lossless", "image.dots_per_inch"};

std::string_view section_of(std::string_view path) {
    return path.substr(0, path.find('.'));
}

bool may_change(std::string_view path) {
    return std::ranges::find(sections, section_of(path)) != sections.end() &&
           std::ranges::none_of(left_out,
                                [&](std::string_view out) { return path.starts_with(out); });
}

Json page_key(const Key& key, const Key& usual) {
    Json json = key_json(usual);
    json["key"] = key.path;
    json["section"] = section_of(key.path);
    json["value"] = value_text(key);
    return json;
}

void check_size(const Scene& scene) {
    const ImageSettings& image = scene.view.image;
    const std::int64_t samples =
        image.width * image.height * image.supersampling * image.supersampling;
    if (samples <= trust_limits.samples) return;
    throw InputError(fmt::format(
        "{}pictures of {} samples are larger than the {} that a page may ask for; `fumon view "
        "--trust` lifts this limit",
        scene.at("image.width"), with_commas(samples), with_commas(trust_limits.samples)));
}

}  // namespace

bool is_model_key(std::string_view path) {
    return section_of(path) == "model" && path != "model.name";
}

LookChanges::LookChanges(const Scene& base, const Snapshot& first, bool trusted)
    : base_(base), first_(first), trusted_(trusted), text_(to_toml(base)) {}

Scene LookChanges::with(const std::vector<std::string>& settings) const {
    const std::vector<Override> overrides = read_settings(settings);
    for (const Override& setting : overrides) {
        if (!may_change(setting.path)) {
            throw InputError(fmt::format(
                "{}: {} cannot be changed on the page; give it to `fumon view` with --set",
                setting.place, setting.path));
        }
    }
    Scene scene = base_;
    if (overrides.empty()) return scene;
    Scene changed = parse_scene(SceneText{text_, base_.source, base_.directory}, overrides);
    if (!trusted_) check_size(changed);
    try {
        read_palette(changed.view.look.palette);
    } catch (const InputError& refusal) {
        throw InputError(changed.at("look.palette") + refusal.what());
    }
    changed.view.drape = base_.view.drape;
    changed.view.placed_layers = base_.view.placed_layers;
    check_shown(changed, first_);
    scene.view = std::move(changed.view);
    return scene;
}

Json LookChanges::keys(const std::string& why_model_is_fixed) const {
    Scene present = base_;
    Scene standard = default_scene(base_.model.name);
    standard.view.overlays.resize(present.view.overlays.size());
    const KeyTable values = scene_keys(present);
    const KeyTable defaults = scene_keys(standard);
    auto list = Json::array();
    for (const Key& key : values.keys()) {
        const bool of_model = is_model_key(key.path);
        if (!may_change(key.path) && !of_model) continue;
        const Key* usual = defaults.find(key.path);
        Json json = page_key(key, usual != nullptr ? *usual : key);
        if (of_model && !why_model_is_fixed.empty()) json["fixed"] = why_model_is_fixed;
        list.push_back(std::move(json));
    }
    return list;
}

Json LookChanges::keys_of_further_overlay() const {
    Scene further = base_;
    const std::size_t number = further.view.overlays.size();
    further.view.overlays.emplace_back();
    const std::string begin = fmt::format("overlay.{}.", number);
    const KeyTable table = scene_keys(further);
    auto list = Json::array();
    for (const Key& key : table.keys())
        if (key.path.starts_with(begin)) list.push_back(page_key(key, key));
    return list;
}

Json LookChanges::presets() const {
    std::map<std::string, std::map<std::string, std::string>> looks;
    std::set<std::string> decided;
    Scene plain = default_scene(base_.model.name);
    const KeyTable defaults = scene_keys(plain);
    for (const std::string& name : look_preset_names()) {
        Scene scene = default_scene(base_.model.name);
        const KeyTable table = scene_keys(scene);
        apply_look_preset(table, name, "look.preset");
        for (const Key& key : table.keys()) {
            const Key* usual = defaults.find(key.path);
            const std::string value = value_text(key);
            if (usual == nullptr || !may_change(key.path) || value == value_text(*usual)) continue;
            looks[name][key.path] = value;
            decided.insert(key.path);
        }
        looks[name];
    }
    auto list = Json::array();
    for (auto& [name, settings] : looks) {
        for (const std::string& path : decided)
            settings.try_emplace(path, value_text(*defaults.find(path)));
        list.push_back({{"name", name}, {"settings", settings}});
    }
    return list;
}

std::string LookChanges::scene_file(const std::vector<std::string>& settings) const {
    return fmt::format("{}{} from the window of `fumon view`.\n{}", own_scene_mark, FUMON_VERSION,
                       to_toml(with(settings)));
}

}  // namespace fumon
