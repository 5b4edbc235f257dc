#pragma once

#include <variant>

#include "base/image.h"
#include "gl/texture.h"
#include "render/frame/tile_frame.h"
#include "render/frame_passes.h"
#include "render/renderer_state.h"
#include "render/samples/accumulated_light.h"
#include "render/samples/float_picture.h"

namespace fumon {

/// A tile while its passes run: the condition and the work of each line of frame_passes.cpp. The
/// passes' types, in their rooms, define the drawing; here they get their targets.
class TileDrawing {
  public:
    /// Where the tile's pixels go: into a picture of 8 bits, into a deeper one, or to what a lens
    /// gathers.
    using Output = std::variant<Image*, FloatPicture*, AccumulatedLight*>;

    TileDrawing(RendererState& state, const Tile& tile, const Camera& camera, Output output);

    /// Whether block_passes() draw it, else sample_passes().
    [[nodiscard]] bool by_block_passes() const;

    /// Before a pass draws.
    void begin(const Pass<TileDrawing>& pass) { pass_ = &pass; }

    // Whether a pass is needed.
    [[nodiscard]] bool always() const { return true; }
    [[nodiscard]] bool dry() const { return !state_.water; }
    [[nodiscard]] bool wet() const { return state_.water; }
    [[nodiscard]] bool closed() const { return !state_.open(); }
    [[nodiscard]] bool of_block() const { return !state_.world; }
    [[nodiscard]] bool has_visibility_buffer() const {
        return state_.world && state_.world->has_visibility_buffer();
    }
    [[nodiscard]] bool in_target() const {
        return !(has_visibility_buffer() && packed() && !streamed());
    }
    [[nodiscard]] bool copied() const { return has_visibility_buffer() && in_target(); }
    [[nodiscard]] bool world_target() const { return state_.world && !has_visibility_buffer(); }
    [[nodiscard]] bool streamed() const { return state_.streamers.has_value(); }
    [[nodiscard]] bool water_pixels() const { return state_.water_block.has_value(); }
    [[nodiscard]] bool single_surface_pixels() const { return state_.targets.has_pixel_colours(); }
    [[nodiscard]] bool packed() const;
    [[nodiscard]] bool unpacked() const { return !packed(); }
    [[nodiscard]] bool upsampled() const { return single_surface_pixels() && unpacked(); }
    [[nodiscard]] bool world_samples() const { return state_.world && unpacked(); }
    [[nodiscard]] bool with_tracks() const { return state_.tracks.has_value(); }
    [[nodiscard]] bool with_plants() const { return state_.plants.has_value(); }
    [[nodiscard]] bool with_persons() const { return state_.persons.has_value(); }
    [[nodiscard]] bool with_air() const { return state_.air.has_value(); }
    [[nodiscard]] bool behind_first() const;
    [[nodiscard]] bool behind_last() const;
    [[nodiscard]] bool behind_lens() const { return state_.lens() && closed(); }
    [[nodiscard]] bool behind_air() const { return with_air() && !state_.lens(); }

    // Passes of a block alone.
    void draw_dry_block();
    void rasterise_water();
    void shade_water();
    void resolve_water();
    void draw_background_beside_block();
    void shade_sides();
    void composite();

    // Passes of samples.
    void draw_background();
    void rasterise_world_buffer();
    void clear_visibility();
    void copy_visibility();
    void rasterise_world();
    void rasterise_block();
    void draw_streamers();
    void shade_water_samples();
    void shade_world_pixels();
    void shade_world_edges();
    void clear_samples();
    void draw_background_behind_samples();
    void draw_background_behind_air();
    void upsample_world_pixels();
    void shade_world();
    void shade_block();
    void draw_prints();
    void draw_plants();
    void draw_persons();
    void draw_air();
    void draw_uncovered_background();
    void resolve();

  private:
    /// Throws std::logic_error where the line of the pass does not name the target.
    void use(Target target) const;
    const gl::RenderTarget& visibility();
    const gl::RenderTarget& pixel_colours();
    const gl::RenderTarget& sample_colours();
    const gl::RenderTarget& background();
    BlockRasteriser& coverage();
    Image& image();
    [[nodiscard]] const StreamerLayer* streamers() const;
    void bind_no_attributes() const;
    void read_background(const std::optional<RowOrder>& drawn);

    RendererState& state_;
    TileFrame tile_;
    Output output_;
    const Pass<TileDrawing>* pass_ = nullptr;
};

}  // namespace fumon
