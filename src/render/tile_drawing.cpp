#include "render/tile_drawing.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "gl/functions.h"

namespace fumon {

TileDrawing::TileDrawing(RendererState& state, const Tile& tile, const Camera& camera,
                         Output output)
    : state_(state),
      tile_{state.view, state.plan, tile, camera, state.light, state.pool},
      output_(output) {}

/// 8 bits of a block alone, in the scenic look. Maps stay what they are.
bool TileDrawing::by_block_passes() const {
    return std::holds_alternative<Image*>(output_) && state_.drawn_by_block_passes(tile_.camera);
}

/// Whether nothing stands on endless ground, so that samples of edges alone need colours.
bool TileDrawing::packed() const {
    return single_surface_pixels() && state_.kind == PixelFormat::display_8 && !with_air() &&
           !with_plants() && !with_persons() && !with_tracks();
}

/// What is seen of it is known only after the ground, or it is seen through streamers.
bool TileDrawing::behind_last() const {
    if (!closed() || state_.lens()) return false;
    return streamed() ||
           (std::holds_alternative<Image*>(output_) && single_surface_pixels() && !with_air());
}

bool TileDrawing::behind_first() const {
    return closed() && !state_.lens() && !behind_last();
}

void TileDrawing::use(Target target) const {
    if (pass_ != nullptr && (pass_->reads.has(target) || pass_->writes.has(target))) return;
    throw std::logic_error(
        "a pass uses a target that its line in frame_passes.cpp does not name: " +
        std::string(pass_ != nullptr ? pass_->name : "none"));
}

const gl::RenderTarget& TileDrawing::visibility() {
    use(Target::visibility);
    return state_.targets.visibility();
}

const gl::RenderTarget& TileDrawing::pixel_colours() {
    use(Target::pixel_colours);
    return state_.targets.pixel_colours();
}

const gl::RenderTarget& TileDrawing::sample_colours() {
    use(Target::sample_colours);
    return state_.targets.sample_colours();
}

const gl::RenderTarget& TileDrawing::background() {
    use(Target::background);
    return state_.targets.background();
}

BlockRasteriser& TileDrawing::coverage() {
    use(Target::coverage);
    if (!state_.coverage)
        state_.coverage.emplace(state_.water ? 0.0F : state_.terrain.grain_strength());
    return *state_.coverage;
}

Image& TileDrawing::image() {
    use(Target::picture);
    return *std::get<Image*>(output_);
}

const StreamerLayer* TileDrawing::streamers() const {
    return state_.streamers ? &*state_.streamers : nullptr;
}

void TileDrawing::bind_no_attributes() const {
    gl::functions().BindVertexArray(state_.no_attributes.name());
}

void TileDrawing::read_background(const std::optional<RowOrder>& drawn) {
    if (!drawn) return;
    if (FloatPicture** deep = std::get_if<FloatPicture*>(&output_)) {
        (*deep)->read_background(tile_.tile);
    } else {
        state_.bytes.read_background(tile_.tile, *drawn);
    }
}

void TileDrawing::draw_dry_block() {
    state_.dry_block.draw(tile_, state_.terrain, state_.shading, coverage(), image());
}

void TileDrawing::rasterise_water() {
    state_.water_block->rasterise(tile_, state_.terrain, state_.shading, coverage());
}

void TileDrawing::shade_water() {
    bind_no_attributes();
    state_.water_block->shade(tile_, state_.terrain, state_.shading);
}

void TileDrawing::resolve_water() {
    state_.water_block->resolve(tile_, coverage(), image());
}

void TileDrawing::draw_background_beside_block() {
    read_background(state_.background.draw_uncovered(tile_, background(), streamers(),
                                                     coverage().background_rectangles()));
}

/// In the background's target, after that has been read.
void TileDrawing::shade_sides() {
    BlockSidesPass::draw(tile_, state_.terrain, state_.targets.background(), coverage());
}

void TileDrawing::composite() {
    BlockCompositePass::draw(tile_, state_.bytes.behind(), coverage(), image());
}

void TileDrawing::draw_background() {
    const bool keep = std::holds_alternative<Image*>(output_);
    read_background(state_.background.draw(tile_, background(), streamers(), keep));
}

void TileDrawing::rasterise_world_buffer() {
    state_.world->rasterise_buffer(tile_);
}

void TileDrawing::clear_visibility() {
    const gl::Functions& gl = gl::functions();
    visibility().bind();
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void TileDrawing::copy_visibility() {
    visibility().bind();
    state_.world->copy_visibility(tile_);
}

void TileDrawing::rasterise_world() {
    visibility().bind();
    state_.world->rasterise(tile_.camera, tile_.samples());
}

void TileDrawing::rasterise_block() {
    visibility().bind();
    state_.terrain.rasterise(tile_.camera, tile_.samples());
}

void TileDrawing::draw_streamers() {
    RendererState& s = state_;
    const glm::ivec2 first = tile_.first_in_target();
    const int factor = tile_.plan.factor;
    const GroundTransform ground = s.ground_transform(tile_.camera);
    std::vector<StreamerLayer::Occluder> occluders;
    if (s.plants)
        occluders.emplace_back([&](const TileSamples& pixels) {
            s.plants->rasterise_depths(ground, tile_.camera, pixels);
        });
    if (s.persons)
        occluders.emplace_back([&](const TileSamples& pixels) {
            s.persons->rasterise_depths(ground, tile_.camera, pixels);
        });
    s.streamers->draw(visibility().colour(), first, factor, tile_.tile, tile_.light, tile_.camera,
                      occluders);
    if (s.plants) s.plants->set_streamers(&*s.streamers, first, factor);
    if (s.persons) s.persons->set_streamers(&*s.streamers, first, factor);
    s.world->set_streamers(&*s.streamers, first);
}

void TileDrawing::shade_water_samples() {
    bind_no_attributes();
    state_.water_block->shade(visibility().colour(), tile_, state_.terrain, state_.shading);
}

void TileDrawing::shade_world_pixels() {
    use(Target::pixel_colours);
    state_.world->shade_pixels(state_.targets, state_.shading, tile_);
}

void TileDrawing::shade_world_edges() {
    use(Target::edge_colours);
    if (!state_.edges) state_.edges.emplace(tile_.plan.factor);
    pixel_colours().bind();
    const gl::Texture2D* samples = in_target() ? &visibility().colour() : nullptr;
    state_.world->shade_packed_samples(samples, *state_.edges, state_.shading, tile_);
}

void TileDrawing::clear_samples() {
    sample_colours().bind();
    gl::functions().Clear(GL_COLOR_BUFFER_BIT);
}

void TileDrawing::draw_background_behind_samples() {
    state_.background.draw_behind_samples(tile_, sample_colours(), streamers());
}

void TileDrawing::draw_background_behind_air() {
    sample_colours().bind();
    bind_no_attributes();
    state_.air->draw_behind(background().colour(), tile_.plan.factor, tile_.first_in_target(),
                            {tile_.tile.width, tile_.tile.height});
}

void TileDrawing::upsample_world_pixels() {
    sample_colours().bind();
    state_.world->upsample_pixels(pixel_colours().colour(), tile_);
}

void TileDrawing::shade_world() {
    sample_colours().bind();
    state_.world->shade_samples(visibility().colour(), state_.shading, tile_);
}

void TileDrawing::shade_block() {
    const gl::Texture2D& colours =
        state_.water_block ? state_.water_block->colours() : state_.shading.colours();
    const glm::ivec2 offset = pixel_offset(tile_.first_in_target(), tile_.plan.factor);
    sample_colours().bind();
    state_.terrain.shade_samples(visibility().colour(), colours, tile_.light, tile_.camera,
                                 tile_.samples(), offset);
}

void TileDrawing::draw_prints() {
    sample_colours().bind();
    state_.tracks->draw(visibility().colour(), state_.world ? &*state_.world : nullptr,
                        state_.ground_transform(tile_.camera), state_.shading, tile_.light,
                        tile_.camera, tile_.samples());
}

void TileDrawing::draw_plants() {
    sample_colours().bind();
    state_.plants->draw(state_.ground_transform(tile_.camera), state_.shading, tile_.light,
                        tile_.camera, tile_.samples());
}

void TileDrawing::draw_persons() {
    sample_colours().bind();
    state_.persons->draw(state_.ground_transform(tile_.camera), state_.shading, tile_.light,
                         tile_.camera, tile_.samples());
}

void TileDrawing::draw_air() {
    sample_colours().bind();
    state_.air->draw(tile_.camera, tile_.samples());
}

void TileDrawing::draw_uncovered_background() {
    const bool only_there = std::holds_alternative<Image*>(output_) && single_surface_pixels();
    if (!only_there) {
        draw_background();
        return;
    }
    read_background(
        state_.background.draw_uncovered(tile_, background(), streamers(), std::nullopt));
}

void TileDrawing::resolve() {
    use(Target::picture);
    const int factor = tile_.plan.factor;
    const glm::ivec2 first = tile_.first_in_target();
    if (packed()) {
        state_.bytes.resolve(tile_.tile, factor, *state_.edges, tile_.pool, image());
        return;
    }
    sample_colours().bind();
    if (Image** image = std::get_if<Image*>(&output_)) {
        state_.bytes.resolve(tile_.tile, factor, first, tile_.pool, **image);
    } else if (FloatPicture** deep = std::get_if<FloatPicture*>(&output_)) {
        (*deep)->resolve(tile_.tile, factor, first, tile_.pool);
    } else {
        std::get<AccumulatedLight*>(output_)->add(first, tile_.pool);
    }
}

}  // namespace fumon
