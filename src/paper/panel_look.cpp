#include "paper/panel_look.h"

#include <fmt/format.h>

#include <cmath>

#include "base/quantity_text.h"
#include "figure/words/words.h"

namespace fumon {

LookSettings look_of(const PanelSettings& panel, const Scene& scene) {
    LookSettings look = scene.view.look;
    if (panel.palette.empty()) {
        look.palette_reversed = look.palette_reversed != panel.palette_reversed;
    } else {
        look.palette = panel.palette;
        look.palette_reversed = panel.palette_reversed;
    }
    if (!panel.low.is_word()) look.low = panel.low;
    if (!panel.high.is_word()) look.high = panel.high;
    look.mode = ViewMode::figure;
    return look;
}

std::optional<Colouring> colouring_of(const std::string& field) {
    if (field == "bed") return Colouring::height;
    if (field == "change") return Colouring::change;
    if (field == "water_depth") return Colouring::water_depth;
    return std::nullopt;
}

RangeTails tails_of(const PanelSettings& panel, double previous) {
    const auto tail = [previous](const WordOrReal& end) {
        if (end.word == "percentile") return RangeTails{}.low;
        return end.word == "auto" ? 0.0 : previous;
    };
    return {tail(panel.low), tail(panel.high)};
}

bool labels_range_ends(const PanelSettings& panel) {
    return panel.low.word != "auto-0.2" && panel.high.word != "auto-0.2";
}

void mark_range_ends(ColourScale& colours, const std::optional<std::pair<double, double>>& values) {
    constexpr double rounding = 1e-6;  // of the range: values may have been single-precision
    const double near = rounding * (colours.high - colours.low);
    colours.ends_labelled = true;
    colours.values_below = values && values->first < colours.low - near;
    colours.values_above = values && values->second > colours.high + near;
}

std::string range_sentence(const ColourScale& colours,
                           const std::optional<std::pair<double, double>>& values) {
    const auto number = [](double value) {
        std::string text = fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);
        if (text.front() == '-') text.replace(0, 1, "\u2212");
        return text;
    };
    const std::string unit = unit_of(colours.label);
    const std::string of = unit.empty() ? "" : " " + unit;
    std::string text =
        phrase("colours from {} to {}", number(colours.low), number(colours.high) + of);
    if (values && (colours.values_below || colours.values_above)) {
        text +=
            phrase(" (values from {} to {})", number(values->first), number(values->second) + of);
    } else if (colours.values_below || colours.values_above) {
        text += word(" (values lie beyond)");
    }
    return text;
}

bool has_compass(PanelArrow arrow) {
    return arrow == PanelArrow::north || arrow == PanelArrow::wind_and_north ||
           arrow == PanelArrow::flow_and_north;
}

std::optional<GroundDirection> direction_of(PanelArrow arrow, const Snapshot& first) {
    if (arrow == PanelArrow::wind || arrow == PanelArrow::wind_and_north)
        return wind_direction(first);
    if (arrow == PanelArrow::flow || arrow == PanelArrow::flow_and_north) return flow_direction();
    return std::nullopt;
}

std::optional<int> row_of(const PanelSettings& panel, const Grid& bed) {
    if (!panel.row_of_bed.is_word()) return static_cast<int>(panel.row_of_bed.value);
    if (panel.row_of_bed.word == "mean") return std::nullopt;
    return bed.ny() / 2;
}

std::string ground_range(const PanelSettings& panel, const Snapshot& snapshot) {
    return fmt::format("{} by {}, {} by {}, {} {}", snapshot.bed.nx(), snapshot.bed.ny(),
                       snapshot.scale.dx, snapshot.scale.dy, panel.x_label, panel.y_label);
}

bool same_ground(const Snapshot& a, const Snapshot& b) {
    return a.bed.nx() == b.bed.nx() && a.bed.ny() == b.bed.ny() && a.scale.dx == b.scale.dx &&
           a.scale.dy == b.scale.dy && a.scale.in_metres == b.scale.in_metres;
}

const char* x_column(bool in_metres) {
    return in_metres ? "x (m)" : "x (sites)";
}

}  // namespace fumon
