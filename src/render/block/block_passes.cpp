#include "render/block/block_passes.h"

#include <cstdint>
#include <vector>

#include "gl/functions.h"
#include "gl/scoped_scissor.h"

namespace fumon {

void DryBlockPass::draw(const TileFrame& tile, const TerrainLayer& terrain,
                        const BedShading& shading, BlockRasteriser& coverage, Image& image) {
    if (!coloured_) {
        shading.read(colours_);
        coverage.set_texture(terrain.grain_over_block(), colours_);
        coloured_ = true;
    }
    coverage.rasterise(terrain.shape(tile.camera), tile.camera, tile.tile, tile.pool, image);
}

void BlockSidesPass::draw(const TileFrame& tile, TerrainLayer& terrain,
                          const gl::RenderTarget& target, BlockRasteriser& coverage) {
    const gl::Functions& gl = gl::functions();
    const TileSamples placed = tile.pixels({target.width(), target.height()});
    for (int side = 0; side < 4; ++side) {
        const Tile& part = coverage.side_rectangle(side);
        if (part.width == 0) continue;
        const glm::ivec2 corner(part.x, tile.tile.height - part.y - part.height);
        target.bind();
        {
            const gl::ScopedScissor scissor(corner, {part.width, part.height});
            gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
            gl.Clear(GL_COLOR_BUFFER_BIT);
            terrain.shade_side(side, tile.light, tile.camera, placed);
        }
        std::vector<std::uint32_t>& colours = coverage.side_colours(side);
        colours.resize(static_cast<std::size_t>(part.width) *
                       static_cast<std::size_t>(part.height));
        gl.ReadPixels(corner.x, corner.y, part.width, part.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      colours.data());
    }
}

void BlockCompositePass::draw(const TileFrame& tile, const std::vector<ColourPlanes>& background,
                              const BlockRasteriser& coverage, Image& image) {
    coverage.finish(background, tile.pool, image);
}

}  // namespace fumon
