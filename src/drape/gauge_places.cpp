#include "drape/gauge_places.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "drape/layer_places.h"
#include "keys/key_value.h"
#include "scene/scene_keys.h"

namespace fumon {

PlacedLayer placed_gauges(const Scene& scene, const LayerSettings& layer,
                          const InitialBed& initial) {
    Scene copy = scene;
    const KeyTable keys = scene_keys(copy);
    const TableList* gauges = keys.find_list("gauge");
    const auto& place = initial.scale.place;
    VectorLayer of_gauges;
    if (place) of_gauges.crs = place->crs;
    const std::size_t count = gauges == nullptr ? 0 : gauges->size();
    for (std::size_t n = 0; n < count; ++n) {
        const auto key = [&](const char* name) {
            return keys.find(fmt::format("gauge.{}.{}", n, name));
        };
        const bool of_map = value_text(*key("coordinates")) == "\"map\"";
        if (of_map && !place) continue;
        const auto point = [&](const std::vector<double>& at) -> VectorPoint {
            if (of_map || !place) return {at[0], at[1]};
            return {place->west + at[0] / initial.scale.dx * place->dx,
                    place->south + at[1] / initial.scale.dy * place->dy};
        };
        const auto& at = *std::get<RealListTarget>(key("at")->target).values;
        const auto& to = *std::get<RealListTarget>(key("to")->target).values;
        if (at.size() != 2) continue;
        VectorFeature feature;
        feature.shape = to.size() == 2 ? VectorShape::lines : VectorShape::points;
        feature.parts = {{point(at)}};
        if (to.size() == 2) feature.parts.front().push_back(point(to));
        if (!layer.label.empty()) {
            const std::string& name = *std::get<std::string*>(key("name")->target);
            feature.label = name.empty() ? fmt::format("gauge_{}", n + 1) : name;
        }
        of_gauges.features.push_back(std::move(feature));
    }
    return placed_layer(of_gauges, {initial.bed.nx(), initial.bed.ny(), place},
                        {initial.scale.dx, initial.scale.dy});
}

}  // namespace fumon
