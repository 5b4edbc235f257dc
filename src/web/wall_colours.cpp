#include "web/wall_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/view/camera.h"
#include "render/view/framing.h"
#include "render/view/water.h"
#include "run/frame_painter.h"
#include "web/page_surface.h"

namespace fumon {

namespace {

constexpr int width = 480;
constexpr int height = 300;
constexpr std::array<double, 4> azimuths{90.0, 0.0, 270.0, 180.0};

using Samples = std::array<std::vector<std::uint8_t>, 3>;

void sample(const Image& image, const Camera& camera, const glm::dvec3& point, Samples& samples) {
    const glm::dvec2 at = project(camera, point);
    const int x = static_cast<int>(std::floor((0.5 + 0.5 * at.x) * image.width));
    const int y = static_cast<int>(std::floor((0.5 - 0.5 * at.y) * image.height));
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    for (std::size_t k = 0; k < 3; ++k)
        samples[k].push_back(image.row(y)[3 * static_cast<std::size_t>(x) + k]);
}

std::optional<PageColour> median(Samples& samples) {
    if (samples[0].empty()) return std::nullopt;
    PageColour colour{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto middle = samples[k].begin() + static_cast<std::ptrdiff_t>(samples[k].size() / 2);
        std::ranges::nth_element(samples[k], middle);
        colour[k] = *middle;
    }
    return colour;
}

/// The middle of an outer side, in the block.
glm::dvec2 middle_of(const OuterSide& side, const Snapshot& surface, const Block& block) {
    glm::dvec2 at(side.x + 0.5, side.y + 0.5);
    if (side.face == 0) at.x += 0.5;
    if (side.face == 1) at.y += 0.5;
    if (side.face == 2) at.x -= 0.5;
    if (side.face == 3) at.y -= 0.5;
    return {(at.x / surface.bed.nx() - 0.5) * block.width_x,
            (at.y / surface.bed.ny() - 0.5) * block.width_y};
}

}  // namespace

WallColours wall_colours(Scene scene, const Snapshot& first, const Snapshot& snapshot,
                         const Snapshot& surface, gl::Backend backend, WorkerPool& pool) {
    constexpr PageColour plain{150, 140, 125};
    constexpr PageColour clear{70, 84, 88};
    constexpr double thin = 3.0;  // pixels of water, of which fewer show no colour
    scene.view.image.width = width;
    scene.view.image.height = height;
    scene.view.camera = {};
    scene.view.camera.elevation = 14.0;
    const Block block =
        block_of_frame(framed_block(scene.view, first), scene.view.look, first, surface);
    const std::vector<OuterSide> sides =
        outer_sides(surface.bed.nx(), surface.bed.ny(), surface.nodata);
    Field<float> depths;
    if (draws_water(scene.view.look, surface)) depths = water_depths(surface);
    WallColours colours;
    for (std::size_t face = 0; face < azimuths.size(); ++face) {
        scene.view.camera.azimuth = azimuths[face];
        const Image image =
            make_frame_painter(scene, first, backend, pool, PaintedContent::one_picture)
                ->paint(snapshot, {});
        const Camera camera =
            place_camera(scene.view.camera, block, static_cast<double>(width) / height, 0.0);
        Samples ground;
        Samples water;
        for (const OuterSide& side : sides) {
            if (side.face != static_cast<int>(face)) continue;
            const glm::dvec2 at = middle_of(side, surface, block);
            const double z = block.z(surface.bed(side.x, side.y));
            sample(image, camera, {at, 0.5 * (block.base + z)}, ground);
            if (depths.empty()) continue;
            const double depth = static_cast<double>(depths(side.x, side.y)) /
                                 surface.scale.height_unit * block.height_scale;
            const double pixels =
                0.5 * height *
                std::abs(project(camera, {at, z + depth}).y - project(camera, {at, z}).y);
            if (pixels > thin) sample(image, camera, {at, z + 0.5 * depth}, water);
        }
        colours.ground[face] = median(ground).value_or(plain);
        colours.water[face] = median(water).value_or(clear);
    }
    return colours;
}

}  // namespace fumon
