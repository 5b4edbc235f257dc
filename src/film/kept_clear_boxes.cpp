#include <glm/glm.hpp>
#include <vector>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "film/film_painter.h"
#include "scene/overlay_keys.h"

namespace fumon {

/// Of blocks side by side, each is seen clear of what stands over the whole picture.
void FilmPainter::keep_clear(double edge) {
    if (layout_.boxes().size() < 2 || stage_.scene.view.look.ground == Ground::endless) return;
    Scene lettered = stage_.scene;
    lettered.view.image.width = size_.width;
    lettered.view.image.height = size_.height;
    lettered.view.layers.clear();
    lettered.view.placed_layers.reset();
    lettered.view.look.contours = WordOrReal{"none", 0.0};
    std::erase_if(lettered.view.overlays,
                  [](const OverlaySettings& overlay) { return overlay.kind == OverlayKind::plot; });
    name_parameter_keys(lettered);
    std::vector<PlacedOverlay> placed;
    try {
        placed = FrameOverlays(lettered, runs_.first().first(),
                               {film_.settings.plates == Plates::none, true, edge,
                                runs_.first().beds().back().time, layout_.strip()})
                     .placed();
    } catch (const KeyError&) {
        return;  // place_overlays() says at which key
    }
    for (const PaneBox& pane : layout_.boxes()) {
        const auto in_pane = [&](double x, double y) {
            return glm::dvec2(2.0 * (x - pane.x) / pane.width - 1.0,
                              1.0 - 2.0 * (y - pane.y) / pane.height);
        };
        for (const PlacedOverlay& overlay : placed) {
            const CanvasBox& box = overlay.box;
            stage_.kept_clear.push_back(
                {in_pane(box.x, box.y + box.height), in_pane(box.x + box.width, box.y)});
        }
    }
}

}  // namespace fumon
