#include "figure/ground/snapshot_layers.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "figure/ground/ground_contours.h"
#include "figure/ground/stream_lines.h"

namespace fumon {

namespace {

constexpr double index_contour_width = 1.5;
constexpr double wider_by_order = 0.5;

LayerFeature line_feature(std::vector<BedPlace> places, double width, std::string label) {
    LayerFeature feature;
    feature.width = width;
    if (!label.empty() && !places.empty()) feature.anchor = places[places.size() / 2];
    feature.label = std::move(label);
    feature.lines.push_back(std::move(places));
    return feature;
}

std::optional<GroundContours> contours_over(WordOrReal interval, const Snapshot& snapshot,
                                            ManyContours many) {
    constexpr double wider = 10.0;
    while (true) {
        try {
            return ground_contours(interval, snapshot);
        } catch (const InputError&) {
            if (many == ManyContours::refused) throw;
        }
        interval.value *= wider;
    }
}

PlacedLayer contour_layer(const LayerSettings& settings, const Snapshot& snapshot,
                          ManyContours many) {
    PlacedLayer layer;
    const auto contours = contours_over(settings.interval, snapshot, many);
    if (!contours) return layer;
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    for (const ContourLine& line : contours->lines) {
        std::vector<BedPlace> places;
        places.reserve(line.points.size());
        for (const glm::dvec2& point : line.points)
            places.push_back({(point.x + 0.5) / nx, (point.y + 0.5) / ny});
        const bool index = is_index_contour(line.level, contours->interval);
        layer.features.push_back(line_feature(
            std::move(places), index ? index_contour_width : 1.0,
            index && !settings.label.empty() ? contour_label(line.level, contours->interval) : ""));
    }
    return layer;
}

PlacedLayer stream_layer(const LayerSettings& settings, const Snapshot& snapshot) {
    PlacedLayer layer;
    for (StreamLine& stream : stream_lines(snapshot, settings.channel_area)) {
        if (stream.order < settings.least_order) continue;
        layer.features.push_back(
            line_feature(std::move(stream.places), 1.0 + wider_by_order * (stream.order - 1),
                         settings.label.empty() ? "" : std::to_string(stream.order)));
    }
    return layer;
}

}  // namespace

bool any_of_ground(std::span<const LayerSettings> settings) {
    return std::ranges::any_of(settings, [](const LayerSettings& layer) {
        return layer.data == LayerData::contours || layer.data == LayerData::streams;
    });
}

void place_ground_layers(std::span<const LayerSettings> settings, const Snapshot& snapshot,
                         PlacedLayers& placed, ManyContours many) {
    for (std::size_t n = 0; n < settings.size(); ++n) {
        if (settings[n].data == LayerData::contours)
            placed.layers[n] = contour_layer(settings[n], snapshot, many);
        if (settings[n].data == LayerData::streams)
            placed.layers[n] = stream_layer(settings[n], snapshot);
    }
}

std::shared_ptr<const PlacedLayers> layers_over(const View& view, const Snapshot& snapshot) {
    if (!view.placed_layers || !any_of_ground(view.layers)) return view.placed_layers;
    auto placed = std::make_shared<PlacedLayers>(*view.placed_layers);
    place_ground_layers(view.layers, snapshot, *placed);
    return placed;
}

}  // namespace fumon
