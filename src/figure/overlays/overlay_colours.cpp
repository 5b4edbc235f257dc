#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"
#include "figure/panels/colour_bar.h"
#include "figure/panels/map_picture.h"
#include "figure/words/words.h"
#include "render/colour/colouring.h"

namespace fumon {

namespace {

/// What colours mean.
struct ColourQuantity {
    std::string label;
    double factor = 1.0;  ///< from the unit of colour_range() to the label's
};

/// `called`: the name of a height or a field; empty: the usual one.
ColourQuantity quantity_of(const LookSettings& look, const Snapshot& first,
                           const std::string& called) {
    const WorldScale& scale = first.scale;
    const auto height = [&](Word usual) -> ColourQuantity {
        const std::string name = called.empty() ? word(usual) : called;
        if (!scale.in_metres)
            return {fmt::format("{} ({})", name, unit_word("model heights")), 1.0};
        constexpr double short_bed = 10.0;
        const bool small =
            std::max(first.bed.nx() * scale.dx, first.bed.ny() * scale.dy) < short_bed;
        return {fmt::format("{} ({})", name, small ? "mm" : "m"),
                (small ? 1e3 : 1.0) * scale.height_unit};
    };
    switch (look.colour_by) {
        case Colouring::field:
        case Colouring::field_change:
            return {field_label(look, first, called), 1.0};
        case Colouring::slope:
            return {labelled("slope", "°"), 1.0};
        case Colouring::change:
            return height("change of height");
        case Colouring::water_depth:
            return {labelled("water depth", "m"), 1.0};
        case Colouring::speed:
            return {labelled("speed", "m/s"), 1.0};
        case Colouring::froude:
            return {word("Froude number"), 1.0};
        case Colouring::drainage:
            return {
                labelled("drainage area", scale.in_metres ? word("log10 m²") : word("log10 cells")),
                1.0};
        case Colouring::natural:
        case Colouring::height:
            break;
    }
    return height("height");
}

class ColourBarOverlay : public Overlay {
  public:
    ColourBarOverlay(const OverlayScene& on, double length, const std::string& called)
        : quantity_(quantity_of(on.scene.view.look, on.shown, called)), length_(length) {
        scale_.palette = chosen_palette(on.scene.view.look);
        const LookSettings& look = on.scene.view.look;
        const bool of_frame = look.range == ColourSpan::frame && ranges_by_values(look);
        scale_.label = quantity_.label + (of_frame ? word(", ends of this frame") : "");
    }

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        const double font = canvas.font_size();
        const PanelMargins margins = colour_bar_margins(canvas, {0.0, 0.0, length_, thick * font},
                                                        scale_, BarDirection::level);
        return {length_ + 2.0 * ends * font, margins.above + thick * font + margins.below};
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const FrameColourRange& colours = frame.colours;
        return fmt::format("{} {} {} {}", colours.low, colours.high, colours.values_below,
                           colours.values_above);
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const double font = canvas.font_size();
        ColourScale scale = scale_;
        scale.low = quantity_.factor * frame.colours.low;
        scale.high = quantity_.factor * frame.colours.high;
        scale.values_below = frame.colours.values_below;
        scale.values_above = frame.colours.values_above;
        const CanvasBox bar{box.x + ends * font, box.y + 0.5 * canvas.line_width(), length_,
                            thick * font};
        draw_colour_bar(canvas, bar, scale, BarDirection::level);
    }

  private:
    static constexpr double thick = 0.8;  // font sizes
    static constexpr double ends = 1.4;   // room for half a tick label at both ends

    ColourQuantity quantity_;
    ColourScale scale_;
    double length_;
};

}  // namespace

/// The frame's colours as a level bar: the palette and range with which they were drawn, and the
/// quantity with its unit; heights in metres where the bed has them, in millimetres on beds shorter
/// than 10 m. None where the colours mean no quantity (look.colour_by = "natural"), nor over a
/// section's flat figure, which has bars of its own.
std::unique_ptr<Overlay> make_colour_bar_overlay(const OverlayScene& on, std::size_t number) {
    const Scene& scene = on.scene;
    if (on.flat) {
        throw KeyError(
            overlay_key(number, "kind"),
            fmt::format("overlay.{} is a colour bar, and a section's figure has its own", number));
    }
    if (scene.view.look.colour_by == Colouring::natural) {
        throw KeyError(
            overlay_key(number, "kind"),
            fmt::format("overlay.{} is a colour bar, and natural colours show no quantity; take "
                        "look.colour_by = \"height\" or another one",
                        number));
    }
    return std::make_unique<ColourBarOverlay>(
        on, scene.view.overlays[number].size * static_cast<double>(scene.view.image.width),
        scene.view.overlays[number].text);
}

}  // namespace fumon
