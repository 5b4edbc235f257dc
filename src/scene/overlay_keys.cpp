#include "scene/overlay_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "keys/keys.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

std::vector<std::string> written_model_keys(const Scene& scene, const KeyTable& table) {
    std::vector<std::string> keys;
    for (const Key& key : table.keys()) {
        const bool of_model = key.role == KeyRole::parameter && key.path.starts_with("model.");
        if (of_model && scene.locations.contains(key.path)) keys.push_back(key.path);
    }
    if (keys.empty()) keys.emplace_back("model.name");
    return keys;
}

}  // namespace

void name_parameter_keys(Scene& scene) {
    Scene copy = scene;  // the table binds to writable values
    const KeyTable table = scene_keys(copy);
    std::vector<std::string> known;
    known.reserve(table.keys().size());
    for (const Key& key : table.keys()) known.push_back(key.path);
    for (std::size_t i = 0; i < scene.view.overlays.size(); ++i) {
        OverlaySettings& overlay = scene.view.overlays[i];
        if (shown_by(overlay.kind) != OverlayShows::keys) continue;
        for (const std::string& key : overlay.keys) {
            if (table.find(key) != nullptr) continue;
            throw InputError(fmt::format("{}there is no key {} to show; {}",
                                         scene.at(fmt::format("overlay.{}.keys", i)), key,
                                         suggestion(key, known)));
        }
        if (overlay.keys.empty()) overlay.keys = written_model_keys(scene, table);
    }
}

bool has_overlays(const Scene& scene) {
    const auto& overlays = scene.view.overlays;
    return scene.view.look.draws_contours() || !scene.view.layers.empty() ||
           scene.view.look.survey_edge == SurveyEdge::line ||
           std::any_of(overlays.begin(), overlays.end(),
                       [](const OverlaySettings& overlay) { return overlay.show; });
}

std::vector<std::string> plotted_columns(const Scene& scene) {
    std::vector<std::string> names;
    for (const OverlaySettings& overlay : scene.view.overlays) {
        if (!overlay.show || shown_by(overlay.kind) != OverlayShows::measurements) continue;
        names.push_back(overlay.x);
        names.push_back(overlay.y);
    }
    return names;
}

std::vector<std::string> recorded_columns(const Scene& scene) {
    std::vector<std::string> names = scene.output.columns;
    if (names.empty()) return names;
    for (std::string& name : plotted_columns(scene)) {
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

}  // namespace fumon
