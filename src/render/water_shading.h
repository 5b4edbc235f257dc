#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/view/block.h"
#include "render/view/water.h"
#include "scene/scene.h"

namespace fumon {

/// What shaders/bed/water.glsl needs to know of a snapshot's water.
class WaterShading {
  public:
    /// For a display bed of nx × ny cells.
    WaterShading(const View& view, const Block& block, int nx, int ny);

    /// Takes the water of a snapshot.
    void upload(const Snapshot& snapshot, const DisplayWater& water);

    /// Sets the uniforms of the program in use; its textures take the units from `unit` on.
    void set_uniforms(const gl::Program& program, int unit) const;

    /// The depth at which the bed is half hidden in what was taken last, metres.
    [[nodiscard]] double clarity() const { return clarity_; }

  private:
    View view_;
    Block block_;
    double cell_x_;  ///< block lengths
    double cell_y_;
    gl::Texture2D water_;
    gl::Texture2D slopes_;
    gl::Texture2D streaks_;
    double clarity_ = 1.0;
    double usual_froude_ = 0.0;
    double closed_depth_ = 1.0;  ///< m
};

}  // namespace fumon
