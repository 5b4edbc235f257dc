#include "paper/panel_look.h"

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

std::optional<GroundDirection> direction_of(PanelArrow arrow, const Snapshot& first) {
    if (arrow == PanelArrow::wind) return wind_direction(first);
    if (arrow == PanelArrow::flow) return flow_direction();
    return std::nullopt;
}

std::optional<int> row_of(const PanelSettings& panel, const Grid& bed) {
    if (!panel.row_of_bed.is_word()) return static_cast<int>(panel.row_of_bed.value);
    if (panel.row_of_bed.word == "mean") return std::nullopt;
    return bed.ny() / 2;
}

const char* x_column(bool in_metres) {
    return in_metres ? "x (m)" : "x (sites)";
}

}  // namespace fumon
