#include "figure/overlays/frame_layers.h"

#include <optional>

#include "figure/canvas/layers.h"
#include "figure/ground/snapshot_layers.h"
#include "figure/layers/draw_layers.h"
#include "figure/overlays/survey_edge.h"
#include "figure/panels/projected_ground.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"
#include "render/view/surrounding_plain.h"

namespace fumon {

namespace {

bool shows_survey_edge(const OverlayScene& on) {
    return on.scene.view.look.survey_edge == SurveyEdge::line && is_bounded(on.first) &&
           is_endless(on.scene.view, on.first);
}

}  // namespace

FrameLayers::FrameLayers(const OverlayScene& on, double font_size)
    : scene_(on.scene),
      first_(on.shown),
      block_(framed_block(on.scene.view, on.shown)),
      length_x_(on.first.bed.nx() * on.first.scale.dx),
      length_y_(on.first.bed.ny() * on.first.scale.dy),
      moves_(on.camera_moves || on.scene.view.camera.turn != 0.0),
      font_size_(font_size) {
    if (shows_survey_edge(on)) {
        settings_.push_back(survey_edge_settings());
        placed_.layers.push_back(survey_edge(on.first));
    }
    if (const auto& placed = scene_.view.placed_layers) {
        settings_.insert(settings_.end(), scene_.view.layers.begin(), scene_.view.layers.end());
        placed_.layers.insert(placed_.layers.end(), placed->layers.begin(), placed->layers.end());
        place_ground_layers(settings_, first_, placed_);
    }
}

bool FrameLayers::has_any(const OverlayScene& on) {
    if (on.first.section || on.first.bed.ny() < 2) return false;
    return on.scene.view.placed_layers != nullptr || shows_survey_edge(on);
}

void FrameLayers::draw(Image& image, const OverlayFrame& frame, const std::vector<CanvasBox>& taken,
                       double opacity) const {
    const std::optional<Snapshot> reshaped = shown_snapshot(frame.snapshot, scene_.view);
    const Snapshot& snapshot = reshaped ? *reshaped : frame.snapshot;
    const Block block = block_of_frame(block_, scene_.view.look, first_, snapshot);
    const Camera camera =
        frame.camera != nullptr
            ? *frame.camera
            : above_ground(camera_at_step(scene_.view, block_, snapshot.step, scene_.run.steps),
                           block, snapshot);
    const CanvasBox picture{0.0, 0.0, static_cast<double>(image.width),
                            static_cast<double>(image.height)};
    const ViewProjection view{camera, block, picture};
    PlacedLayers with_ground;
    const bool of_ground = any_of_ground(settings_);
    if (of_ground) {
        with_ground = placed_;
        place_ground_layers(settings_, snapshot, with_ground, ManyContours::thinned);
    }
    const auto layers = seen_layers(
        {settings_, of_ground ? with_ground : placed_, picture, length_x_, length_y_, false},
        ProjectedGround(snapshot, view));
    Canvas canvas(image.width, image.height, font_size_, CanvasGround::transparent);
    draw_layers(canvas, picture, settings_, layers, taken, {1.0, moves_});
    composite_over(image, canvas.layer(), 0, 0, opacity);
}

}  // namespace fumon
