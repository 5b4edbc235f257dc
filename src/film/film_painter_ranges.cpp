#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "figure/overlays/overlay_plot.h"
#include "film/film_painter.h"
#include "numerics/contour_lines.h"
#include "render/colour/colouring.h"
#include "render/view/water.h"

namespace fumon {

/// What scenes take from each frame is taken from all beds that the film shows.
void FilmPainter::fix_ranges(const std::set<Moment>& shown) {
    note_jumps();
    fix_colours(shown);
    fix_contours(shown);
    fix_plots(shown);
}

namespace {

/// The range of a record's colours; of values that are one, that one, and of none an empty range,
/// which widen a film's range by nothing else.
std::pair<double, double> ends_of_record(const LookSettings& look, const Snapshot& bed,
                                         const Field<float>& values) {
    const FrameColourRange range = frame_colour_range(look, bed, values, {}, true);
    if (range.kept) return {range.low, range.high};
    const Mask without = uncoloured_cells(look, bed);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values.values()[i];
        if (without.empty() || without.values()[i] == 0) return {value, value};
    }
    return {INFINITY, -INFINITY};
}

}  // namespace

void FilmPainter::fix_colours(const std::set<Moment>& shown) {
    LookSettings& look = stage_.scene.view.look;
    const bool ranged = ranges_by_values(look) && look.range == ColourSpan::run;
    const bool watery = look.water && look.water_clarity.is_word() &&
                        runs_.first().first().landform == Landform::water;
    if (!ranged && !watery) return;
    double low = INFINITY;
    double high = -INFINITY;
    double clarity = 0.0;
    for (const Moment& moment : shown) {
        for (std::size_t run = 0; run < panes_.size(); ++run) {
            const StoredBeds& beds = *panes_[run].beds;
            const auto bed = beds.snapshot(bed_of(run, moment));
            if (watery) clarity = std::max(clarity, water_clarity(look, water_statistics(*bed)));
            if (!ranged || (differs() && run > 0)) continue;
            const auto other = differs() ? panes_[1].beds->snapshot(bed_of(1, moment)) : nullptr;
            const Field<float> values = coloured_values(look, *bed, other ? *other : beds.first());
            const auto [from, to] = ends_of_record(look, *bed, values);
            low = std::min(low, from);
            high = std::max(high, to);
        }
    }
    if (ranged && low < high) {
        if (look.low.is_word()) look.low = low;
        if (look.high.is_word()) look.high = high;
    }
    if (watery && clarity > 0.0) look.water_clarity = clarity;
}

/// Of contours whose interval is "auto": a round one for all beds, since with one of each bed's own
/// lines would jump from frame to frame.
void FilmPainter::fix_contours(const std::set<Moment>& shown) {
    View& view = stage_.scene.view;
    const auto is_auto = [](const LayerSettings& layer) {
        return layer.data == LayerData::contours && layer.interval.is_word();
    };
    const bool of_look = view.look.contours.word == "auto";
    if (!of_look && !std::ranges::any_of(view.layers, is_auto)) return;
    double low = INFINITY;
    double high = -INFINITY;
    for (const Moment& moment : shown) {
        for (std::size_t run = 0; run < panes_.size(); ++run) {
            const auto bed = panes_[run].beds->heights(bed_of(run, moment));
            const double unit = bed->scale.in_metres ? bed->scale.height_unit : 1.0;
            for (std::size_t i = 0; i < bed->bed.size(); ++i) {
                if (!bed->nodata.empty() && bed->nodata.values()[i] != 0) continue;
                low = std::min(low, unit * bed->bed.values()[i]);
                high = std::max(high, unit * bed->bed.values()[i]);
            }
        }
    }
    if (!(low < high)) return;
    const double interval = contour_interval(low, high);
    if (of_look) view.look.contours = interval;
    for (LayerSettings& layer : view.layers)
        if (is_auto(layer)) layer.interval = interval;
    for (Pane& pane : panes_) pane.scene.view.layers = view.layers;
}

void FilmPainter::fix_plots(const std::set<Moment>& shown) {
    if (shown.empty()) return;
    for (std::size_t i = 0; i < stage_.scene.view.overlays.size(); ++i) {
        OverlaySettings& overlay = stage_.scene.view.overlays[i];
        if (overlay.kind != OverlayKind::plot) continue;
        std::vector<double> values;
        for (std::size_t run = 0; run < panes_.size(); ++run) {
            std::size_t last = 0;
            for (const Moment& moment : shown) last = std::max(last, bed_of(run, moment));
            const MeasuredColumn* column = panes_[run].rows[last].find(overlay.y);
            if (column == nullptr) continue;
            for (std::size_t row = 0; row < column->values.size(); ++row)
                values.push_back(column->values.data()[row]);
        }
        if (values.empty()) continue;
        const auto [low, high] = growing_range(values);
        if (overlay.low.is_word()) overlay.low = low;
        if (overlay.high.is_word()) overlay.high = high;
    }
    for (Pane& pane : panes_) {
        for (std::size_t i = 0; i < pane.scene.view.overlays.size(); ++i) {
            pane.scene.view.overlays[i].low = stage_.scene.view.overlays[i].low;
            pane.scene.view.overlays[i].high = stage_.scene.view.overlays[i].high;
        }
    }
}

}  // namespace fumon
