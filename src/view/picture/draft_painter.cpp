#include "view/picture/draft_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/ready_picture.h"
#include "scene/placed_sun.h"
#include "scene/write.h"
#include "view/picture/camera_pose.h"

namespace fumon {

namespace {

/// What a renderer cannot change from picture to picture.
std::string lasting_look(Scene scene) {
    const CameraSettings camera = scene.view.camera;
    scene.view.camera = CameraSettings{};
    scene.view.camera.projection = camera.projection;
    const SunSettings usual{};
    scene.view.sun.azimuth = usual.azimuth;
    scene.view.sun.elevation = usual.elevation;
    return to_toml(scene);
}

}  // namespace

Scene draft_of(Scene scene, int width, int height) {
    ImageSettings& image = scene.view.image;
    const double factor =
        std::min({1.0, static_cast<double>(width) / static_cast<double>(image.width),
                  static_cast<double>(height) / static_cast<double>(image.height)});
    constexpr double smallest = 16.0;
    const auto smaller = [&](std::int64_t side) {
        return static_cast<std::int64_t>(
            std::max(smallest, std::round(factor * static_cast<double>(side))));
    };
    image.width = smaller(image.width);
    image.height = smaller(image.height);
    image.supersampling = 1;
    image.deep_colour = false;
    scene.view.camera.f_number = WordOrReal{"pinhole", 0.0};
    scene.view.camera.aperture = 0.0;
    return scene;
}

void DraftPainter::close() {
    if (context_) context_->make_current();
    lit_.reset();
    renderer_.reset();
    context_.reset();
}

Image DraftPainter::paint(const Scene& scene, const Snapshot& first,
                          const std::shared_ptr<const Snapshot>& snapshot) {
    std::string look = lasting_look(scene);
    if (!renderer_ || look != look_) {
        close();
        context_ = gl::Context::create(backend_);
        RenderLimits limits;
        limits.draft = true;
        renderer_ = std::make_unique<Renderer>(*context_, scene.view, first, scene.run.steps, pool_,
                                               limits);
        look_ = std::move(look);
    }
    FramePose pose;
    pose.camera = camera_of_still(scene, first, *snapshot);
    pose.share = share_of_run(snapshot->step, scene.run.steps);
    pose.sun = sun_at(scene.view.sun, pose.share);
    const ReadyPicture ready = renderer_->ready(snapshot, pose, lit_, pool_);
    lit_ = ready.lit;
    return renderer_->render(ready);
}

}  // namespace fumon
