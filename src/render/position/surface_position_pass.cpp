#include "render/position/surface_position_pass.h"

#include <cstddef>
#include <vector>

#include "gl/functions.h"

namespace fumon {

SurfacePositionPass::SurfacePositionPass(const Tile& largest)
    : surface_("position/bed_position.vert.glsl", "position/position.frag.glsl",
               {"east_north", "height"}),
      sides_("position/side_position.vert.glsl", "position/position.frag.glsl",
             {"east_north", "normal", "heights"}),
      leaves_("position/plant_position.vert.glsl", "position/position.frag.glsl",
              {"leaf", "leaf_normal", "root", "form"}),
      persons_("position/person_position.vert.glsl", "position/position.frag.glsl",
               {"part", "part_normal", "part_colour"}),
      depths_(largest.width, largest.height),
      target_(largest.width, largest.height,
              {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE}, &depths_) {}

void SurfacePositionPass::draw(const TileFrame& tile, const Scene& scene,
                               SurfacePositionLayers& layers) const {
    const TileSamples pixels = tile.pixels({target_.width(), target_.height()});
    const gl::Functions& gl = gl::functions();
    target_.bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (scene.world != nullptr) {
        scene.world->rasterise(tile.camera, pixels, false);
    } else {
        scene.terrain.rasterise_positions(surface_, sides_, tile.camera, pixels);
    }
    if (scene.plants != nullptr)
        scene.plants->rasterise_positions(leaves_, scene.ground, tile.camera, pixels);
    if (scene.persons != nullptr)
        scene.persons->rasterise_positions(persons_, scene.ground, tile.camera, pixels);
    std::vector<float> texels(4 * static_cast<std::size_t>(tile.tile.width) *
                              static_cast<std::size_t>(tile.tile.height));
    gl.ReadPixels(0, 0, tile.tile.width, tile.tile.height, GL_RGBA, GL_FLOAT, texels.data());
    layers.add(tile.tile, texels, tile.pool);
}

}  // namespace fumon
