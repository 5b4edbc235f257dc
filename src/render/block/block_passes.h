#pragma once

#include "base/image.h"
#include "gl/texture.h"
#include "render/bed/bed_shading.h"
#include "render/block/terrain_layer.h"
#include "render/frame/tile_frame.h"
#include "render/samples/block_rasteriser.h"
#include "render/samples/resolve_vectors.h"

namespace fumon {

/// Rasterises by vector code the block of a dry bed and shades the pixels that see its surface
/// alone, by the colours of the shaded bed.
class DryBlockPass {
  public:
    /// Before the tiles of a picture whose bed has been shaded anew.
    void forget_colours() { coloured_ = false; }
    void draw(const TileFrame& tile, const TerrainLayer& terrain, const BedShading& shading,
              BlockRasteriser& coverage, Image& image);

  private:
    BlockTexture colours_;  // room for the next ones
    bool coloured_ = false;
};

/// Shades by OpenGL the pixels that may see one of the block's sides, in a target of pixels, and
/// reads them.
struct BlockSidesPass {
    static void draw(const TileFrame& tile, TerrainLayer& terrain, const gl::RenderTarget& target,
                     BlockRasteriser& coverage);
};

/// Puts together, sample by sample, the pixels that see more than the surface: with sides, and with
/// the background behind them.
struct BlockCompositePass {
    static void draw(const TileFrame& tile, const std::vector<ColourPlanes>& background,
                     const BlockRasteriser& coverage, Image& image);
};

}  // namespace fumon
