#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/error.h"
#include "figure/overlays/frame_overlays.h"
#include "figure/overlays/overlay_text.h"
#include "film/film_painter.h"
#include "scene/overlay_keys.h"

namespace fumon {

/// Of blocks side by side, each is seen clear of what stands over the whole picture.
void FilmPainter::keep_clear(double edge, const TitleFacts& facts) {
    constexpr double gap_em = 0.3;  // letter sizes
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
    std::vector<CanvasBox> taken;
    taken.reserve(placed.size());
    for (const PlacedOverlay& overlay : placed) taken.push_back(overlay.box);
    FilmStage whole = stage_;
    whole.scene = lettered;
    const std::optional<CanvasBox> captions =
        Titles(film_, whole, runs_.first().first(), facts, timeline_, taken).caption_box();
    for (const PaneBox& pane : layout_.boxes()) {
        const auto in_pane = [&](const CanvasBox& box) {
            const auto at = [&](double x, double y) {
                return glm::dvec2(2.0 * (x - pane.x) / pane.width - 1.0,
                                  1.0 - 2.0 * (y - pane.y) / pane.height);
            };
            return PictureBox{at(box.x, box.y + box.height), at(box.x + box.width, box.y)};
        };
        for (const PlacedOverlay& overlay : placed)
            stage_.kept_clear.push_back(in_pane(grown(overlay.box, gap_em * overlay.font_size)));
        if (captions) stage_.captions.push_back(in_pane(*captions));
    }
}

}  // namespace fumon
