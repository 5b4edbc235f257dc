#include "gl/functions.h"
#include "render/colour/colouring.h"
#include "render/renderer_parts.h"

namespace fumon {

bool Renderer::Parts::coloured_by_pixels(const Camera& camera) const {
    const bool alone = !world && !air && !plants && !persons && !tracks && !terrain.has_rim();
    const bool by_pixels = kind == PixelKind::display_8 && view.look.mode == ViewMode::scenic &&
                           view.camera.projection != Projection::map && plan.factor == 2 && alone;
    if (water)
        return by_pixels && water_pixels && (camera.perspective || terrain.lies_before(camera));
    return by_pixels && !shading.has_mipmaps() && terrain.lies_before(camera);
}

void Renderer::Parts::read_block_colours() {
    if (!block_samples) block_samples.emplace(terrain.grain_strength());
    shading.read(block_colours);
    block_samples->set_colours(terrain.grain_over_block(), block_colours);
    block_coloured = true;
}

void Renderer::Parts::draw_block_sides(const Tile& tile, const Camera& camera) {
    const gl::Functions& gl = gl::functions();
    const glm::vec2 picture(static_cast<float>(view.image.width),
                            static_cast<float>(view.image.height));
    const int below = static_cast<int>(view.image.height) - tile.y - tile.height;
    const gl::RenderTarget& target = surroundings();
    const TileSamples placed{picture, glm::vec2(tile.x, below),
                             glm::vec2(target.width(), target.height())};
    for (int side = 0; side < 4; ++side) {
        const Tile& part = block_samples->part_of_side(side);
        if (part.width == 0) continue;
        const int lowest = tile.height - part.y - part.height;
        target.bind();
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(part.x, lowest, part.width, part.height);
        gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        terrain.shade_side(side, light, camera, placed);
        gl.Disable(GL_SCISSOR_TEST);
        std::vector<std::uint32_t>& colours = block_samples->colours_of_side(side);
        colours.resize(static_cast<std::size_t>(part.width) *
                       static_cast<std::size_t>(part.height));
        gl.ReadPixels(part.x, lowest, part.width, part.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      colours.data());
    }
}

void Renderer::Parts::find_water_kinds(const DisplayWater& standing, const Snapshot& shown) {
    const bool tinted = !colours_water(view.look.colour_by);
    Field<float> depth = standing.depth;
    if (!tinted) std::ranges::fill(depth.values(), 0.0F);
    if (water_pixels->alike()) std::ranges::fill(depth.values(), 1e9F);
    water_kinds = kind_map(depth, closed_depth(shown.scale));
}

void Renderer::Parts::shade_block_pixels(const Tile& tile, const Camera& camera, Image& image) {
    const glm::vec2 cells(shading.cells());
    const glm::vec3 low = terrain.low();
    const BlockSamples::Seeing seeing{
        camera,
        {image.width, image.height},
        {terrain.height_span()},
        {&water_kinds, cells, low - glm::vec3(camera.eye), terrain.high() - low,
         static_cast<float>(2.0 * camera.half.y / static_cast<double>(view.image.height)),
         camera.perspective, WaterPixels::near_cells, WaterPixels::near_widths}};
    if (!block_samples) block_samples.emplace(0.0F);
    block_samples->see_places(terrain.shape(camera), tile, seeing, pool, block_places);
    gl::functions().BindVertexArray(no_attributes.name());
    water_pixels->shade(block_places, {shading, terrain, light, camera});
    block_samples->put_colours(block_places, pool, image);
}

void Renderer::Parts::draw_block(const Tile& tile, const Camera& camera, Image& image) {
    if (water) {
        shade_block_pixels(tile, camera, image);
    } else {
        if (!block_coloured) read_block_colours();
        block_samples->see(terrain.shape(camera), camera, tile, pool, image);
    }
    if (!image.transparent()) draw_uncovered_background(tile, camera);
    draw_block_sides(tile, camera);
    block_samples->finish(bytes.behind(), pool, image);
}

}  // namespace fumon
