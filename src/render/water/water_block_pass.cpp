#include "render/water/water_block_pass.h"

#include <algorithm>

namespace fumon {

void WaterBlockPass::find_kinds(const DisplayWater& standing, const Snapshot& shown, bool tinted) {
    Field<float> depth = standing.depth;
    if (!tinted) std::ranges::fill(depth.values(), 0.0F);
    if (pixels_.alike()) std::ranges::fill(depth.values(), 1e9F);
    kinds_ = kind_map(depth, closed_depth(shown.scale));
}

void WaterBlockPass::rasterise(const TileFrame& tile, const TerrainLayer& terrain,
                               const BedShading& shading, BlockRasteriser& coverage) {
    const Camera& camera = tile.camera;
    const glm::vec2 cells(shading.cells());
    const glm::vec3 low = terrain.low();
    const BlockRasteriser::GBufferSetup setup{
        camera,
        tile.picture(),
        {terrain.height_span()},
        {&kinds_, cells, low - glm::vec3(camera.eye), terrain.high() - low,
         static_cast<float>(2.0 * camera.half.y / static_cast<double>(tile.picture().y)),
         camera.perspective, WaterPixels::split_distance_cells,
         WaterPixels::split_distance_pixels}};
    coverage.fill_g_buffer(terrain.shape(camera), tile.tile, setup, tile.pool, positions_);
}

void WaterBlockPass::shade(const TileFrame& tile, const TerrainLayer& terrain,
                           const BedShading& shading) {
    pixels_.shade(positions_, {shading, terrain, tile.light, tile.camera});
}

void WaterBlockPass::resolve(const TileFrame& tile, BlockRasteriser& coverage, Image& image) {
    coverage.resolve_shading(positions_, tile.pool, image);
}

void WaterBlockPass::shade(const gl::Texture2D& visibility, const TileFrame& tile,
                           const TerrainLayer& terrain, const BedShading& shading) {
    pixels_.shade(visibility, pixel_offset(tile.first_in_target(), tile.plan.factor),
                  {shading, terrain, tile.light, tile.camera}, tile.samples());
}

}  // namespace fumon
