#include "render/view/framing.h"

#include <algorithm>

namespace fumon {

Block framed_block(const View& view, const Snapshot& first) {
    const double exaggeration = view.look.exaggeration.is_word() ? automatic_exaggeration(first)
                                                                 : view.look.exaggeration.value;
    return frame_block(first, exaggeration, view.look.room);
}

Camera camera_at_step(const View& view, const Block& block, std::int64_t step,
                      std::int64_t last_step) {
    const double progress =
        last_step > 0 ? static_cast<double>(step) / static_cast<double>(last_step) : 0.0;
    const double aspect =
        static_cast<double>(view.image.width) / static_cast<double>(view.image.height);
    return place_camera(view.camera, block, aspect, std::clamp(progress, 0.0, 1.0));
}

double pixels_per_length(const Camera& camera, const View& view) {
    const double depth = camera.perspective ? -glm::dot(camera.eye, camera.forward) : 1.0;
    return 0.5 * static_cast<double>(view.image.height) / (camera.half.y * std::max(depth, 0.05));
}

}  // namespace fumon
