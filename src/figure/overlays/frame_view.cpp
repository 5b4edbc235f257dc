#include "figure/overlays/frame_view.h"

#include <optional>

#include "figure/canvas/layers.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

FrameView::FrameView(const OverlayScene& on, double font_size)
    : scene_(on.scene),
      first_(on.shown),
      block_(framed_block(on.scene.view, on.shown)),
      font_size_(font_size) {}

void FrameView::draw_over(Image& image, const OverlayFrame& frame, double opacity,
                          const Drawing& draw) const {
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
    Canvas canvas(image.width, image.height, font_size_, CanvasGround::transparent);
    draw(canvas, snapshot, {camera, block, picture});
    composite_over(image, canvas.layer(), 0, 0, opacity);
}

}  // namespace fumon
