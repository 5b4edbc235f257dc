#include "view/picture/look_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "keys/describe_key.h"
#include "keys/key_value.h"
#include "keys/keys.h"
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

nlohmann::ordered_json LookChanges::keys() const {
    Scene present = base_;
    Scene standard = default_scene(base_.model.name);
    standard.view.overlays.resize(present.view.overlays.size());
    const KeyTable values = scene_keys(present);
    const KeyTable defaults = scene_keys(standard);
    auto list = nlohmann::ordered_json::array();
    for (const Key& key : values.keys()) {
        if (!may_change(key.path)) continue;
        const Key* usual = defaults.find(key.path);
        nlohmann::ordered_json json = key_json(usual != nullptr ? *usual : key);
        json["key"] = key.path;
        json["section"] = section_of(key.path);
        json["value"] = value_text(key);
        list.push_back(std::move(json));
    }
    return list;
}

std::string LookChanges::scene_file(const std::vector<std::string>& settings) const {
    return fmt::format("{}{} from the window of `fumon view`.\n{}", own_scene_mark, FUMON_VERSION,
                       to_toml(with(settings)));
}

}  // namespace fumon
