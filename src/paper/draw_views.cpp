#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/quantity_text.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/map_picture.h"
#include "figure/panels/relief_view.h"
#include "figure/panels/view_panel.h"
#include "figure/words/words.h"
#include "files/terrain/terrain_format.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "render/renderer.h"

namespace fumon {

namespace {

/// The colours of a view where nothing is said of their ends: all values that the panel shows.
void take_whole_range(LookSettings& look, const PanelSettings& panel, const Snapshot& first,
                      const std::vector<Snapshot>& snapshots) {
    if (!ranges_by_values(look) || panel.low.word == "auto-0.2" || panel.high.word == "auto-0.2")
        return;
    if (panel.low.word != "auto" && panel.high.word != "auto") return;
    std::vector<Field<float>> values;
    values.reserve(snapshots.size());
    for (const Snapshot& snapshot : snapshots)
        values.push_back(coloured_values(look, snapshot, first));
    const auto [low, high] = joined_colour_range(look, snapshots, values, tails_of(panel));
    look.low = {"", low};
    look.high = {"", high};
}

/// Light, block and colours of a view whose relief is to read in print.
void make_clear(View& view, const PanelSubject& subject) {
    const PanelSettings& panel = subject.panel.settings;
    if (panel.colours == PanelColouring::plain) view.look.colour_by = Colouring::natural;
    if (panel.colours == PanelColouring::height) view.look.colour_by = Colouring::height;
    // That of sand seen as sand gives way: to colours that are light throughout, since shade
    // darkens them.
    if (view.look.palette == "sand" && view.look.colour_by != Colouring::natural)
        view.look.palette = view.look.colour_by == Colouring::height
                                ? "hypsometric"
                                : usual_palette(view.look.colour_by);
    view = relief_view(std::move(view), subject.first, subject.snapshots);
}

/// The bar of a view's colours, and what the caption says of them.
struct ViewColours {
    ColourScale scale;
    std::string remark;
};

std::optional<ViewColours> colours_of(const View& view, const PanelSubject& subject) {
    const PanelSettings& panel = subject.panel.settings;
    if (panel.relief != PanelRelief::clear || view.look.colour_by == Colouring::natural)
        return std::nullopt;
    const auto pictures =
        map_pictures(view.look, subject.snapshots, subject.first, tails_of(panel));
    std::optional<std::pair<double, double>> values;
    for (const MapPicture& picture : pictures) {
        const auto own = values_of(picture);
        if (!own) continue;
        values = values ? std::pair{std::min(values->first, own->first),
                                    std::max(values->second, own->second)}
                        : *own;
    }
    ViewColours colours{pictures.front().colours, {}};
    colours.scale.label = label_or(panel.bar_label, colours.scale.label);
    if (labels_range_ends(panel)) mark_range_ends(colours.scale, values);
    colours.remark = range_sentence(colours.scale, values);
    return colours;
}

/// The view of a panel's scene, in the panel's look and as many pixels as its place on the page
/// has.
View view_of(const PanelSubject& subject, double dots_per_inch) {
    const PanelPlan& panel = subject.panel;
    View view = panel.picture->scene.view;
    view.look = look_of(panel.settings, panel.picture->scene);
    if (const auto colouring = colouring_of(panel.settings.field);
        colouring && *colouring != Colouring::height)
        view.look.colour_by = *colouring;
    if (panel.settings.relief == PanelRelief::clear) make_clear(view, subject);
    take_whole_range(view.look, panel.settings, subject.first, subject.snapshots);
    constexpr double points_per_inch = 72.0;
    const double aspect =
        static_cast<double>(view.image.height) / static_cast<double>(view.image.width);
    const double pixels = dots_per_inch / points_per_inch * subject.width;
    view.image.width = std::max<std::int64_t>(16, std::llround(pixels));
    view.image.height = std::max<std::int64_t>(16, std::llround(pixels * aspect));
    if (panel.settings.relief == PanelRelief::clear) view.image.dots_per_inch = dots_per_inch;
    return view;
}

std::vector<MadePanel> make_views(const PanelSubject& subject, PanelTools& tools) {
    const PanelSettings& settings = subject.panel.settings;
    const auto steps = static_cast<double>(subject.panel.picture->scene.run.steps);
    const View view = view_of(subject, tools.plan.scene.figure.dots_per_inch);
    if (!tools.context) tools.context = gl::Context::create(tools.backend);
    Renderer renderer(*tools.context, view, subject.first, subject.panel.picture->scene.run.steps,
                      tools.pool);
    const std::optional<ViewColours> colours = colours_of(view, subject);
    std::vector<MadePanel> made;
    for (const Snapshot& snapshot : subject.snapshots) {
        const double progress = steps > 0.0 ? static_cast<double>(snapshot.step) / steps : 0.0;
        ViewSettings shown;
        shown.scale_bar = settings.scale_bar;
        shown.arrow = direction_of(settings.arrow, subject.first);
        shown.compass = has_compass(settings.arrow);
        MadePanel one;
        if (renderer.exaggeration() != 1.0)
            one.remarks.push_back(
                phrase("heights × {}", fmt::format("{:g}", renderer.exaggeration())));
        if (colours) {
            one.remarks.push_back(colours->remark);
            shown.colours = colours->scale;
            if (settings.colour_bar && made.size() + 1 == subject.snapshots.size())
                shown.colour_bar = BarPosition::right;
        }
        shown.coordinates = settings.coordinates;
        ViewPicture picture = view_picture(view, renderer.render(snapshot), subject.first,
                                           renderer.exaggeration(), progress);
        add_contours(picture, view, settings.contours, subject.first, snapshot);
        add_layers(picture, view, subject.first, snapshot);
        if (!picture.contours.empty()) {
            one.remarks.push_back(
                phrase("contours every {} {}", fmt::format("{:g}", picture.contour_interval),
                       unit_word(height_unit(picture.in_metres, INFINITY).symbol)));
        }
        one.content = std::make_unique<ViewPanel>(std::move(picture), std::move(shown));
        for (TerrainBytes& file : bed_files(snapshot, std::array{std::string("esri-ascii")}))
            one.data.push_back({std::move(file.ending), std::move(file.bytes)});
        made.push_back(std::move(one));
    }
    return made;
}

}  // namespace

const PanelMaker panels::view{nullptr, make_views};

}  // namespace fumon
