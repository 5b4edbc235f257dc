#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/block/terrain_layer.h"
#include "render/frame/ground_transform.h"
#include "render/frame/tile_frame.h"
#include "render/life/person_layer.h"
#include "render/life/plant_layer.h"
#include "render/position/surface_position_layers.h"
#include "render/world/world_layer.h"

namespace fumon {

/// Rasterises the surface point at the middle of each pixel, into a target of its own, and passes
/// it to SurfacePositionLayers.
class SurfacePositionPass {
  public:
    /// `largest`: of the tiles.
    explicit SurfacePositionPass(const Tile& largest);

    /// What is seen: endless ground or else the block, and what stands on it; nullptr: none.
    struct Scene {
        const WorldLayer* world;
        TerrainLayer& terrain;
        const PlantLayer* plants;
        const PersonLayer* persons;
        GroundTransform ground;  ///< of these
    };
    void draw(const TileFrame& tile, const Scene& scene, SurfacePositionLayers& layers) const;

  private:
    gl::Program surface_;
    gl::Program sides_;
    gl::Program leaves_;
    gl::Program persons_;
    gl::DepthBuffer depths_;
    gl::RenderTarget target_;
};

}  // namespace fumon
