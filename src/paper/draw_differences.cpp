#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/quantity_text.h"
#include "base/snapshot_lookup.h"
#include "figure/panels/map_panel.h"
#include "figure/words/words.h"
#include "paper/map_content.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"

namespace fumon {

namespace {

using Values = PanelColours::Values;

/// What is subtracted from what.
struct DifferenceNames {
    std::string of;
    std::string minus;
};

std::string stem_of(const std::string& scene, const std::string& otherwise) {
    return std::filesystem::path(scene.empty() ? otherwise : scene).stem().string();
}

/// The names that the panel gives, else what tells the two apart.
DifferenceNames difference_names(const PanelSettings& settings, const std::string& scene,
                                 std::int64_t step, std::int64_t minus_step) {
    const ChartSettings& chart = settings.chart;
    DifferenceNames names{chart.name, chart.minus_name};
    const bool by_step = chart.minus_scene.empty() && chart.minus_set.empty();
    const auto label_of = [&](const std::vector<std::string>& set, const std::string& file,
                              std::int64_t at) {
        if (by_step) return phrase("step {}", at);
        return set.empty() ? stem_of(file, scene) : fmt::format("{}", fmt::join(set, ", "));
    };
    if (names.of.empty()) names.of = label_of(settings.set, settings.scene, step);
    if (names.minus.empty()) {
        const std::string& file = chart.minus_scene.empty() ? settings.scene : chart.minus_scene;
        names.minus = label_of(chart.minus_set, file, minus_step);
    }
    return names;
}

/// A text that no line breaks.
std::string unbroken(const std::string& text) {
    std::string made;
    for (const char letter : text)
        made += letter == ' ' ? std::string("\u00a0") : std::string(1, letter);
    return made;
}

/// Of the scene's look the palette alone; one that parts in the middle where none is asked for.
LookSettings look_of_difference(const PanelSettings& settings, const Scene& scene) {
    PanelSettings asked = settings;
    if (asked.palette.empty()) asked.palette = "vik";
    LookSettings look = look_of(asked, scene);
    look.low = look.high = {"auto", 0.0};
    if (!settings.high.is_word()) {
        look.high = settings.high;
        look.low = settings.high;
        look.low.value = -settings.high.value;
    }
    look.colour_by = Colouring::change;
    return look;
}

MapPicture difference_of(const PanelSettings& settings, const LookSettings& look,
                         const Snapshot& of, const Snapshot& minus) {
    RangeTails tails;
    if (settings.high.word != "percentile") tails = {0.0, 0.0};
    if (settings.field == "bed" || settings.field == "change")
        return map_picture(look, of, minus, tails);
    MapPicture picture = field_picture(look, of, settings.field, tails);
    const MapPicture other = field_picture(look, minus, settings.field, tails);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values.values()[i] -= other.values.values()[i];
    if (picture.blank.empty()) picture.blank = other.blank;
    if (settings.high.is_word()) {
        const Values values = values_of(picture);
        const double most =
            values ? std::max(std::abs(values->first), std::abs(values->second)) : 0.0;
        picture.colours.high = most > 0.0 ? most : 1.0;
        picture.colours.low = -picture.colours.high;
    }
    return picture;
}

std::vector<MadePanel> make_differences(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    const ChartSettings& chart = settings.chart;
    const PicturePlan& minus = *subject.panel.minus;
    const LookSettings look = look_of_difference(settings, subject.panel.picture->scene);
    std::vector<Snapshot> taken;
    for (const std::int64_t step : minus.steps)
        taken.push_back(tools.store.snapshot(tools.runs[minus.run], step));
    std::vector<MapPicture> pictures;
    double most = 0.0;
    for (std::size_t k = 0; k < subject.snapshots.size(); ++k) {
        pictures.push_back(difference_of(settings, look, subject.snapshots[k],
                                         taken[std::min(k, taken.size() - 1)]));
        most = std::max(most, pictures.back().colours.high);
    }
    std::vector<MadePanel> made;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        MapPicture& picture = pictures[k];
        const bool shared = settings.range == PanelRange::shared;
        if (shared) {
            picture.colours.high = most;
            picture.colours.low = -most;
        }
        const DifferenceNames names =
            difference_names(settings, tools.plan.file, subject.snapshots[k].step,
                             taken[std::min(k, taken.size() - 1)].step);
        const std::string unit = unit_of(picture.colours.label);
        const std::string what =
            settings.field == "bed" || settings.field == "change"
                ? word("height")
                : picture.colours.label.substr(0, picture.colours.label.rfind(" ("));
        picture.colours.label =
            label_or(settings.bar_label,
                     fmt::format("{}: {}{}", what, unbroken(names.of + " \u2212 " + names.minus),
                                 unit.empty() ? "" : " (" + unit + ")"));
        MapPanelSettings shown;
        shown.axes = settings.axes;
        shown.x_label = settings.x_label;
        shown.y_label = settings.y_label;
        const bool bar = settings.colour_bar && (!shared || k + 1 == pictures.size());
        shown.colour_bar = bar ? BarPosition::right : BarPosition::none;
        shown.scale_bar = settings.scale_bar && k == 0;
        MadePanel one;
        one.remarks.push_back(phrase("{} of {} minus that of {}", what, names.of, names.minus));
        const Values values = values_of(picture);
        mark_range_ends(picture.colours, values);
        if (!chart.share_colours) one.remarks.push_back(range_sentence(picture.colours, values));
        if (values && values->first == 0.0 && values->second == 0.0)
            one.warnings.emplace_back("both are the same everywhere");
        WorldScale scale = picture.scale;
        if (scale.place) scale.place = subject.snapshots[k].scale.place;
        put_map(std::move(picture), std::move(shown), scale, values,
                ground_range(settings, subject.snapshots[k]), settings, one);
        made.push_back(std::move(one));
    }
    return made;
}

}  // namespace

const PanelMaker panels::difference{nullptr, make_differences};

}  // namespace fumon
