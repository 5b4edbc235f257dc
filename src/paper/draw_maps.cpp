#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "base/elementary.h"
#include "base/quantity_text.h"
#include "base/units.h"
#include "figure/ground/snapshot_layers.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/hill_shading.h"
#include "figure/panels/map_panel.h"
#include "figure/words/words.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/crest_theory.h"
#include "paper/map_content.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "wind/crest_directions.h"

namespace fumon {

namespace {

/// The look that shows a panel's field, where it is one of the renderer's.
std::optional<LookSettings> look_of_field(const PanelSettings& panel, const Scene& scene) {
    const auto colouring = colouring_of(panel.field);
    if (!colouring) return std::nullopt;
    LookSettings look = look_of(panel, scene);
    look.colour_by = *colouring;
    return look;
}

using Values = std::optional<std::pair<double, double>>;

/// The least and the greatest value of several pictures.
Values values_of_all(std::span<const MapPicture> pictures) {
    Values all;
    for (const MapPicture& picture : pictures) {
        const Values own = values_of(picture);
        if (!own) continue;
        all = all ? std::pair{std::min(all->first, own->first), std::max(all->second, own->second)}
                  : *own;
    }
    return all;
}

void share_range(std::vector<MapPicture>& pictures) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const MapPicture& picture : pictures) {
        low = std::min(low, picture.colours.low);
        high = std::max(high, picture.colours.high);
    }
    for (MapPicture& picture : pictures) {
        picture.colours.low = low;
        picture.colours.high = high;
    }
}

std::vector<MapPicture> map_pictures_of(const PanelPlan& panel, const Snapshot& first,
                                        const std::vector<Snapshot>& snapshots) {
    const Scene& scene = panel.picture->scene;
    const bool shared = panel.settings.range == PanelRange::shared;
    const auto look = look_of_field(panel.settings, scene);
    if (look && shared) return map_pictures(*look, snapshots, first, tails_of(panel.settings));
    std::vector<MapPicture> pictures;
    pictures.reserve(snapshots.size());
    for (const Snapshot& snapshot : snapshots) {
        pictures.push_back(look ? map_picture(*look, snapshot, first, tails_of(panel.settings))
                                : field_picture(look_of(panel.settings, scene), snapshot,
                                                panel.settings.field,
                                                tails_of(panel.settings, 0.0)));
    }
    if (shared) share_range(pictures);
    return pictures;
}

/// A picture may have larger cells than its snapshot, from the same south-west corner.
WorldScale scale_of_values(const MapPicture& picture, const Snapshot& snapshot) {
    WorldScale scale = picture.scale;
    if (!scale.place) return scale;
    scale.place = snapshot.scale.place;
    scale.place->dx *= scale.dx / snapshot.scale.dx;
    scale.place->dy *= scale.dy / snapshot.scale.dy;
    return scale;
}

/// The crests that are measured, and over them those that their winds should give.
std::vector<MapLine> crest_lines_of(const Snapshot& snapshot, double flux_ratio) {
    const auto along = [](double degrees) {
        return glm::dvec2(elementary::sin(degrees * degree), elementary::cos(degrees * degree));
    };
    const CrestDirections predicted = predicted_crests(snapshot, flux_ratio);
    std::vector<MapLine> lines;
    const double measured =
        crest_theory(crest_orientation(snapshot.bed, snapshot.periodic), predicted).measured;
    if (!std::isnan(measured)) lines.push_back({along(measured), false});
    for (const double crests : predicted.bed_instability) lines.push_back({along(crests), true});
    return lines;
}

std::vector<MadePanel> make_maps(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    std::vector<MapPicture> pictures =
        map_pictures_of(subject.panel, subject.first, subject.snapshots);
    if (settings.shading > 0.0) {
        HillShading shading;
        shading.strength = settings.shading;
        shading.from_all_sides = settings.shading_from_all_sides;
        for (std::size_t k = 0; k < pictures.size(); ++k)
            pictures[k].light = hill_light(subject.snapshots[k], shading, tools.pool);
    }
    const bool shared = settings.range == PanelRange::shared;
    const Values values = values_of_all(pictures);
    std::vector<MadePanel> made;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        MapPicture& picture = pictures[k];
        picture.background = subject.panel.picture->scene.view.drape;
        MapPanelSettings shown;
        shown.axes = settings.axes;
        shown.x_label = settings.x_label;
        shown.y_label = settings.y_label;
        if (settings.coordinates)
            shown.coordinates = scale_of_values(picture, subject.snapshots[k]);
        picture.colours.label = label_or(settings.bar_label, picture.colours.label);
        const bool bar = settings.colour_bar && (!shared || k + 1 == pictures.size());
        shown.colour_bar = bar ? BarPosition::right : BarPosition::none;
        if (k == 0) {
            shown.scale_bar = settings.scale_bar;
            shown.arrow = direction_of(settings.arrow, subject.first);
            shown.compass = has_compass(settings.arrow);
        }
        if (settings.vectors) shown.flow = water_flow_of(subject.snapshots[k]);
        if (settings.crests)
            shown.lines = crest_lines_of(subject.snapshots[k], settings.flux_ratio);
        shown.contours = ground_contours(settings.contours, subject.snapshots[k]);
        shown.layers = subject.panel.picture->scene.view.layers;
        shown.placed_layers = layers_over(subject.panel.picture->scene.view, subject.snapshots[k]);
        MadePanel one;
        const Values own = shared ? values : values_of(picture);
        if (labels_range_ends(settings)) mark_range_ends(picture.colours, own);
        if (!settings.chart.share_colours)
            one.remarks.push_back(range_sentence(picture.colours, own));
        if (own && (own->second < picture.colours.low || own->first > picture.colours.high)) {
            one.warnings.push_back(
                fmt::format("all values ({:.4g} to {:.4g}) lie beyond the ends of the colours",
                            own->first, own->second));
        }
        if (shown.contours) {
            one.remarks.push_back(
                phrase("contours every {} {}", fmt::format("{:g}", shown.contours->interval),
                       unit_word(height_unit(subject.first.scale.in_metres, INFINITY).symbol)));
        }
        const WorldScale scale = scale_of_values(picture, subject.snapshots[k]);
        put_map(std::move(picture), std::move(shown), scale, own,
                ground_range(settings, subject.snapshots[k]), settings, one);
        made.push_back(std::move(one));
    }
    return made;
}

}  // namespace

const PanelMaker panels::map{nullptr, make_maps};

}  // namespace fumon
