#pragma once

#include "base/image.h"
#include "base/snapshot.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/block/terrain_layer.h"
#include "render/frame/tile_frame.h"
#include "render/samples/block_rasteriser.h"
#include "render/samples/g_buffer.h"
#include "render/view/water.h"
#include "render/water/water_pixels.h"

namespace fumon {

/// The surface of a block with water, shaded once a pixel. Which positions a pixel shows is found
/// by vector code, where the block is drawn alone, or from the samples that OpenGL has rasterised.
class WaterBlockPass {
  public:
    /// See WaterPixels.
    WaterBlockPass(const TilePlan& plan, const gl::Constants& fixed, PixelFormat kind, bool alike)
        : pixels_(plan, fixed, kind, alike) {}

    /// Of the water that a picture shows, `tinted` unless its colours have another meaning: where
    /// the vector code tells kinds of pixels apart.
    void find_kinds(const DisplayWater& standing, const Snapshot& shown, bool tinted);

    /// Finds the positions that the pixels of a tile show, by vector code.
    void rasterise(const TileFrame& tile, const TerrainLayer& terrain, const BedShading& shading,
                   BlockRasteriser& coverage);
    /// Shades these.
    void shade(const TileFrame& tile, const TerrainLayer& terrain, const BedShading& shading);
    /// Puts them into the picture.
    void resolve(const TileFrame& tile, BlockRasteriser& coverage, Image& image);

    /// Shades the pixels whose samples are in a target, see TerrainLayer::rasterise().
    void shade(const gl::Texture2D& visibility, const TileFrame& tile, const TerrainLayer& terrain,
               const BedShading& shading);
    /// The colours of shade(), a texel a pixel.
    [[nodiscard]] const gl::Texture2D& colours() const { return pixels_.colours(); }

  private:
    WaterPixels pixels_;
    g_buffer_vectors::KindMap kinds_;
    GBuffer positions_;  // room for the next ones
};

}  // namespace fumon
