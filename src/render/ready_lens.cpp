// Where the lens of a picture is in focus, and through how many of its points it is seen.

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/renderer_state.h"
#include "render/view/bilinear_height.h"
#include "render/view/lens.h"

namespace fumon {

namespace {

constexpr double farthest_focus = 1e6;  // block lengths: as good as infinite

}  // namespace

RayGround RendererState::ground_for_rays(const ReadyPicture& picture) const {
    RayGround rays;
    if (world) {
        const HeightPyramid& heights = *picture.lit->heights;
        rays.height = [this, &heights](const glm::dvec2& position) {
            return world->ground_at(position, heights);
        };
        rays.highest = std::max(static_cast<double>(heights.highest()), block.surface);
        rays.step = 0.3 * std::min(ground.width_x * ground.tiles.count() / heights.finest().nx(),
                                   ground.width_y / heights.finest().ny());
        return rays;
    }
    const DisplayBed& bed = picture.lit->bed;
    const glm::dvec2 extent(block.width_x, block.width_y);
    rays.height = [this, &bed, extent](const glm::dvec2& position) {
        constexpr double nowhere = -1e9;
        const double floor = open() ? nowhere : block.base;
        const glm::dvec2 share = position / extent + 0.5;
        if (glm::any(glm::lessThan(share, glm::dvec2(0.0))) ||
            glm::any(glm::greaterThanEqual(share, glm::dvec2(1.0))))
            return floor;
        const Mask& nodata = bed.nodata;
        if (!nodata.empty() && nodata(static_cast<int>(share.x * nodata.nx()),
                                      static_cast<int>(share.y * nodata.ny())) != 0)
            return floor;
        return static_cast<double>(bilinear_height(bed.z, share, false));
    };
    rays.highest =
        static_cast<double>(*std::max_element(bed.z.values().begin(), bed.z.values().end()));
    rays.highest = std::max(rays.highest, block.base);
    rays.step = 0.3 * std::min(extent.x / bed.z.nx(), extent.y / bed.z.ny());
    return rays;
}

/// A film's pose looks at a place always.
void RendererState::set_lens(ReadyPicture& picture, bool posed) const {
    Camera& camera = picture.pose.camera;
    camera.lens.radius = lens_radius(view.camera, block, camera);
    if (camera.lens.radius == 0.0) return;
    const WordOrReal& asked = view.camera.focus;
    double focus = asked.value / block.side;
    if (asked.is_word()) {
        focus = camera.focus;
        if (!posed && block.look_at) {
            focus = glm::dot(*block.look_at - camera.eye, camera.forward);
        } else if (!posed) {
            focus = depth_of_ground(camera, glm::dvec2(0.0), ground_for_rays(picture));
        }
    }
    camera.lens.focus = std::clamp(focus, 1e-9, farthest_focus);
    const WordOrReal& samples = view.camera.lens_samples;
    if (!samples.is_word()) {
        picture.lens_points = static_cast<int>(samples.value);
        return;
    }
    RayGround coarse = ground_for_rays(picture);
    coarse.growth = 0.01;
    const double widest =
        widest_circle_of_confusion(camera, coarse, static_cast<double>(view.image.height));
    picture.lens_points = enough_lens_points(widest);
}

}  // namespace fumon
