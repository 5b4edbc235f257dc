#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/bed/drape_texture.h"
#include "render/bed/water_shading.h"
#include "render/colour/colouring.h"
#include "render/colour/pixel_format.h"
#include "render/land/land_cover.h"
#include "render/light/light.h"
#include "render/light/light_texels.h"
#include "render/light/repeated_light.h"
#include "render/samples/block_rasteriser.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/display_bed.h"
#include "render/view/drawn_origin.h"
#include "render/view/visible_part.h"
#include "scene/scene.h"

namespace fumon {

/// The bed's colour as the eye sees it, as a texture over the bed: each point is shaded once, and
/// the many samples of a picture only look it up.
class BedShading {
  public:
    /// `samples_across` is the length of the picture's longer side in samples. `mipmaps` outlives
    /// it. `bed_share`: of the ground's tile, that the bed covers eastward and northward. Throws
    /// InputError for an unknown palette.
    BedShading(const View& view, const Block& block, const Snapshot& first,
               const DisplayBed& first_bed, int samples_across, const gl::Constants& fixed,
               const gl::MipmapMaker& mipmaps, PixelFormat kind = PixelFormat::display_8,
               const glm::dvec2& bed_share = glm::dvec2(1.0));

    /// Lets ground of endless maps pale to grey as far as it is invented, 0 … 255.
    void pale(const Field<std::uint8_t>& invented);

    /// Gives the ground of the maps what covers it, where look.cover asks for that.
    void cover(const Field<CellCover>& cells);

    /// Uploads what light (see lighting_texels) and colouring make of a snapshot. `water` is given
    /// where draws_water says so.
    void upload(const Snapshot& snapshot, const Snapshot& first, const LightTexels& lighting,
                const DisplayWater* water);
    /// The same for endless ground.
    void upload(const Snapshot& snapshot, const Snapshot& first, const RepeatedLight& light,
                const DrawnOrigin& origin);
    /// Uploads the water over endless ground; of one that ends, of its own tile.
    void upload_water(const Snapshot& snapshot, const Snapshot& first, const DisplayWater& water);

    /// Shades what was uploaded, unless that is left to WaterPixels.
    void shade(const Light& light, const Camera& camera);

    /// Binds what was uploaded to the units 0 to 4, and a drape, and sets the uniforms of
    /// shaders/bed/bed.glsl, shaders/bed/ground.glsl and shaders/bed/drape.glsl, of the program in
    /// use. `texel`: of what is shaded, of the bed's sides; 0 where that is pixels.
    void bind(const gl::Program& program, const glm::dvec2& texel = glm::dvec2(0.0)) const;
    /// The same, the light of a view and, where there is water, its textures to the units 6 to 10.
    /// `texel`: see WaterShading::set_uniforms().
    void bind_all(const gl::Program& program, const Light& light, const Camera& camera,
                  double texel) const;

    /// Binds the water over endless ground to five units and 14; nothing where none is drawn.
    void bind_water(const gl::Program& program, const std::array<int, 5>& units,
                    const Camera& camera) const;

    /// The values at the palette's ends in what was shaded last.
    [[nodiscard]] const FrameColourRange& range() const { return range_; }
    /// Keeps the range of the first snapshot whose values differ for all later ones, unless
    /// look.range is "frame".
    void keep_range() { keeps_range_ = true; }
    /// The depth of water at which the bed is half hidden there, metres; 1 without water.
    [[nodiscard]] double clarity() const { return water_ ? water_->clarity() : 1.0; }
    /// How turbid all of that water is, 0 clear … 1 muddy; 0 without water.
    [[nodiscard]] double turbidity() const { return water_ ? water_->turbidity() : 0.0; }
    [[nodiscard]] const gl::Texture2D& colours() const { return target_->colour(); }
    [[nodiscard]] const gl::Texture2D& lighting() const { return lighting_; }
    /// Reads them, of 8 bits.
    void read(BlockTexture& colours) const;
    /// Cells of its maps, eastward and northward.
    [[nodiscard]] glm::ivec2 cells() const { return {lighting_.width(), lighting_.height()}; }
    [[nodiscard]] bool has_mipmaps() const { return shaded_mipmaps_; }

  private:
    void draw_noise();
    /// Whether the shaded bed is as fine as what is seen of it asks for.
    [[nodiscard]] bool sized_by_view() const;
    void size_for(const VisiblePart& part);
    Field<float> ranged_values(const Snapshot& snapshot, const Snapshot& first);
    void upload_marks(const Snapshot& snapshot, const Snapshot& first, const DrawnOrigin& origin);

    View view_;
    Block block_;
    int refinement_;
    const gl::MipmapMaker& mipmaps_;
    bool shaded_mipmaps_;
    bool by_pixels_;  ///< see shades_water_by_pixel()
    FrameColourRange range_;
    bool keeps_range_ = false;
    glm::vec2 noise_origin_{0.0F};       ///< where the drawn bed begins
    glm::vec3 floor_coordinates_{0.0F};  ///< of palette places, of endless ground
    glm::vec2 bare_board_{0.0F};         ///< see bare_board()
    gl::Program program_;
    gl::Texture2D palette_;
    gl::Texture2D lighting_;
    gl::Texture2D values_;
    gl::Texture2D marks_;
    gl::Texture2D uncoloured_;
    std::optional<gl::Texture2D> invented_;  ///< see pale()
    std::optional<gl::Texture2D> cover_;     ///< see cover()
    std::optional<gl::RenderTarget> noise_;  // of the ground's colour; none for a figure
    std::optional<WaterShading> water_;
    std::optional<DrapeTexture> drape_;
    gl::TextureLayout target_layout_;
    glm::ivec2 target_size_;  ///< at least
    std::optional<gl::RenderTarget> target_;
};

}  // namespace fumon
