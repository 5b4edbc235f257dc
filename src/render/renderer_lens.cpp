#include <algorithm>
#include <cmath>
#include <limits>

#include "base/give_up.h"
#include "gl/functions.h"
#include "render/frame/view_uniforms.h"
#include "render/renderer_parts.h"
#include "render/view/drawn_height.h"
#include "render/view/lens.h"

namespace fumon {

namespace {

constexpr double farthest_focus = 1e6;  // block lengths: as good as infinite

}  // namespace

/// Reads nothing that drawing changes.
RayGround Renderer::Parts::ground_for_rays(const ReadyPicture& picture) const {
    RayGround rays;
    if (world) {
        const HeightPyramid& heights = *picture.lit->heights;
        rays.height = [this, &heights](const glm::dvec2& place) {
            return world->ground_at(place, heights);
        };
        rays.highest = std::max(static_cast<double>(heights.highest()), block.surface);
        rays.step = 0.3 * std::min(ground.width_x * ground.tiles.count() / heights.finest().nx(),
                                   ground.width_y / heights.finest().ny());
        return rays;
    }
    const DisplayBed& bed = picture.lit->bed;
    const glm::dvec2 extent(block.width_x, block.width_y);
    rays.height = [this, &bed, extent](const glm::dvec2& place) {
        constexpr double nowhere = -1e9;
        const double floor = open() ? nowhere : block.base;
        const glm::dvec2 share = place / extent + 0.5;
        if (glm::any(glm::lessThan(share, glm::dvec2(0.0))) ||
            glm::any(glm::greaterThanEqual(share, glm::dvec2(1.0))))
            return floor;
        const Mask& nodata = bed.nodata;
        if (!nodata.empty() && nodata(static_cast<int>(share.x * nodata.nx()),
                                      static_cast<int>(share.y * nodata.ny())) != 0)
            return floor;
        return static_cast<double>(drawn_height(bed.z, share, false));
    };
    rays.highest =
        static_cast<double>(*std::max_element(bed.z.values().begin(), bed.z.values().end()));
    rays.highest = std::max(rays.highest, block.base);
    rays.step = 0.3 * std::min(extent.x / bed.z.nx(), extent.y / bed.z.ny());
    return rays;
}

/// Likewise. A film's pose looks at a place always.
void Renderer::Parts::set_lens(ReadyPicture& picture, bool posed) const {
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
    const double widest = widest_blur(camera, coarse, static_cast<double>(view.image.height));
    picture.lens_points = enough_lens_points(widest);
}

/// Into the target of samples, where no ground is seen.
void Renderer::Parts::draw_behind_samples(const Tile& tile, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    // The target's own rows and columns, of which the tile's are a part.
    const glm::ivec2 corner = target_corner(tile);
    const int below = static_cast<int>(view.image.height) - plan.target_height;
    const Tile whole{corner.x, below - corner.y, plan.target_width, plan.target_height};
    gl.BindVertexArray(no_attributes.name());
    background.draw_clouds(light, camera, whole);
    sampled->colours->bind();
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.StencilFunc(GL_EQUAL, 0, 0xFF);
    if (streamers) streamers->bind();
    background.draw(light, camera, whole, RowOrder::upward, first_sample(tile) - corner);
    gl.Disable(GL_STENCIL_TEST);
}

GatheredLight Renderer::Parts::gathered_light(const Tile& tile, const Camera& camera,
                                              int lens_points_wanted) {
    GatheredLight gathered(tile);
    const glm::dvec2 pixel(2.0 / static_cast<double>(view.image.width),
                           2.0 / static_cast<double>(view.image.height));
    Camera through = camera;
    for (const LensPoint& point : lens_points(lens_points_wanted)) {
        if (one_picture) give_up_if_asked();
        through.lens.point = camera.lens.radius * point.on_disc;
        through.lens.aside = pixel * point.in_pixel;
        gl::functions().BindVertexArray(no_attributes.name());
        draw_samples(tile, through);
        sampled->colours->bind();
        gathered.add(first_sample(tile) - target_corner(tile), pool);
    }
    gathered.finish(pool);
    return gathered;
}

Image Renderer::Parts::lens_picture(const Camera& camera, int lens_points_wanted) {
    Image image(static_cast<int>(view.image.width), static_cast<int>(view.image.height));
    if (open()) image = with_alpha(std::move(image));
    const bool deep = wanted == PixelKind::display_16;
    if (deep) image.rgb16.resize(image.rgb.size());
    if (!lens_tone)
        lens_tone.emplace(plan.tiles.front(), fixed_uniforms(view, light, ground, wanted), deep);
    for (const Tile& tile : plan.tiles) {
        const GatheredLight gathered = gathered_light(tile, camera, lens_points_wanted);
        gl::functions().BindVertexArray(no_attributes.name());
        lens_tone->put(gathered, view, light, camera, block, image);
    }
    if (open()) spread_colours(image);
    return image;
}

std::vector<ImageLayer> Renderer::Parts::lens_channels(const Camera& camera,
                                                       int lens_points_wanted) {
    DeepPicture picture(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                        kind, open());
    for (const Tile& tile : plan.tiles)
        picture.put(gathered_light(tile, camera, lens_points_wanted));
    return picture.take_channels();
}

}  // namespace fumon
