#include <fmt/format.h>

#include "base/error.h"
#include "figure/layers/draw_layers.h"
#include "figure/overlays/overlay.h"
#include "figure/overlays/overlay_text.h"

namespace fumon {

namespace {

class LegendOverlay : public Overlay {
  public:
    explicit LegendOverlay(const OverlayScene& on) : view_(on.scene.view) {}

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        return layer_legend_size(canvas, view_.layers);
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& /*frame*/) const override {
        return "";
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& /*frame*/) const override {
        if (!view_.placed_layers) return;  // a scene whose files were not read
        draw_layer_legend(canvas, {box.x, box.y}, view_.layers, *view_.placed_layers, 1.0);
    }

  private:
    const View& view_;
};

}  // namespace

/// The signs of the scene's layers and what they show.
std::unique_ptr<Overlay> make_legend_overlay(const OverlayScene& on, std::size_t number) {
    if (!has_legend(on.scene.view.layers)) {
        throw KeyError(overlay_key(number, "kind"),
                       fmt::format("overlay.{} is a legend of layers, and no [[layer]] has one; "
                                   "write layer.legend = \"…\", or leave it out",
                                   number));
    }
    return std::make_unique<LegendOverlay>(on);
}

}  // namespace fumon
