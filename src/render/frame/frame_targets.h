#pragma once

#include <optional>

#include "gl/texture.h"
#include "render/colour/pixel_format.h"
#include "render/view/tiles.h"
#include "scene/scene.h"

namespace fumon {

/// Layout of the visibility: a position on the block, or an offset from the eye on endless ground.
/// `surface`: with its height, of block/visibility_surface.frag.glsl.
gl::TextureLayout visibility_layout(Ground ground, bool surface = false);

/// What the targets of a renderer must hold.
struct TargetNeeds {
    TilePlan plan;
    PixelFormat kind = PixelFormat::display_8;
    Ground ground = Ground::table;
    bool surface_heights = false;  ///< in visibility, see visibility_layout()
    bool pixel_colours = false;    ///< endless ground is shaded by pixels where these can be
};

/// The targets of OpenGL that one pass draws into and another reads, of the largest tile's size.
/// Each is made when it is first needed. A layer has those of its own that no other reads.
class FrameTargets {
  public:
    explicit FrameTargets(TargetNeeds needs);

    /// What each sample sees, with depths and stencils that sample_colours() shares.
    const gl::RenderTarget& visibility();
    [[nodiscard]] bool has_visibility() const { return visibility_.has_value(); }
    /// A colour a sample; alpha 0 where nothing is drawn.
    const gl::RenderTarget& sample_colours();
    /// A colour a pixel of endless ground, with stencils that background() shares: how the pixel
    /// is shaded.
    [[nodiscard]] const gl::RenderTarget& pixel_colours() const { return *pixel_programs_; }
    [[nodiscard]] const gl::DepthBuffer& pixel_stencils() const { return *pixel_stencils_; }
    [[nodiscard]] bool has_pixel_colours() const { return pixel_programs_.has_value(); }
    /// A colour a pixel: what surrounds the ground; sides of a block are drawn there after it has
    /// been read.
    const gl::RenderTarget& background();

  private:
    TargetNeeds needs_;
    std::optional<gl::DepthBuffer> sample_depths_;
    std::optional<gl::RenderTarget> visibility_;
    std::optional<gl::RenderTarget> sample_programs_;
    std::optional<gl::DepthBuffer> pixel_stencils_;
    std::optional<gl::RenderTarget> pixel_programs_;
    std::optional<gl::RenderTarget> background_;
};

}  // namespace fumon
