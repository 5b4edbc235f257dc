#include "figure/overlays/frame_layers.h"

#include "figure/ground/snapshot_layers.h"
#include "figure/layers/draw_layers.h"
#include "figure/overlays/survey_edge.h"
#include "figure/panels/projected_ground.h"
#include "render/view/ground_choice.h"
#include "render/view/surrounding_plain.h"

namespace fumon {

namespace {

bool shows_survey_edge(const OverlayScene& on) {
    return on.scene.view.look.survey_edge == SurveyEdge::line && is_bounded(on.first) &&
           is_endless(on.scene.view, on.first);
}

}  // namespace

FrameLayers::FrameLayers(const OverlayScene& on, double font_size)
    : view_(on, font_size),
      length_x_(on.first.bed.nx() * on.first.scale.dx),
      length_y_(on.first.bed.ny() * on.first.scale.dy),
      moves_(on.camera_moves || on.scene.view.camera.turn != 0.0) {
    if (shows_survey_edge(on)) {
        settings_.push_back(survey_edge_settings());
        placed_.layers.push_back(survey_edge(on.first));
    }
    if (const auto& placed = on.scene.view.placed_layers) {
        const auto& own = on.scene.view.layers;
        settings_.insert(settings_.end(), own.begin(), own.end());
        placed_.layers.insert(placed_.layers.end(), placed->layers.begin(), placed->layers.end());
        place_ground_layers(settings_, view_.first(), placed_);
    }
}

bool FrameLayers::has_any(const OverlayScene& on) {
    if (on.first.section || on.first.bed.ny() < 2) return false;
    return on.scene.view.placed_layers != nullptr || shows_survey_edge(on);
}

void FrameLayers::draw(Image& image, const OverlayFrame& frame, const std::vector<CanvasBox>& taken,
                       double opacity) const {
    view_.draw_over(
        image, frame, opacity,
        [&](Canvas& canvas, const Snapshot& snapshot, const ViewProjection& view) {
            PlacedLayers with_ground;
            const bool of_ground = any_of_ground(settings_);
            if (of_ground) {
                with_ground = placed_;
                place_ground_layers(settings_, snapshot, with_ground, ManyContours::thinned);
            }
            const auto layers = seen_layers({settings_, of_ground ? with_ground : placed_,
                                             view.picture, length_x_, length_y_, false},
                                            ProjectedGround(snapshot, view));
            draw_layers(canvas, view.picture, settings_, layers, taken, {1.0, moves_});
        });
}

}  // namespace fumon
