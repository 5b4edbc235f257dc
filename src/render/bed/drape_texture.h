#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/view/drape.h"
#include "scene/view/view.h"

namespace fumon {

/// One mipmap of a drape: red, green and blue (sRGB) times the opacity, and that, 8 bits each.
struct DrapeLevel {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels;
};

/// A drape and its mipmaps down to one texel. Each is the mean of the finer one's light over the
/// texel's own area, in integers: nothing moves where a side is odd, and what is seen through does
/// not darken the rest.
std::vector<DrapeLevel> drape_levels(const Drape& drape);

/// The drape of a view as shaders/bed/drape.glsl looks it up.
class DrapeTexture {
  public:
    /// `bed_share`: of the ground's tile, that the bed covers eastward and northward.
    DrapeTexture(const Drape& drape, const LookSettings& look, const glm::dvec2& bed_share);

    /// Binds it and sets the uniforms of the program in use. `texel`: of what is shaded, of the
    /// bed's sides; 0 where that is pixels. `origin`: where the drawn bed begins.
    void bind(const gl::Program& program, const glm::dvec2& texel, const glm::vec2& origin) const;

    [[nodiscard]] glm::ivec2 size() const { return {texture_.width(), texture_.height()}; }

  private:
    gl::Texture2D texture_;
    float strength_;
    glm::vec2 bed_share_;
};

}  // namespace fumon
