#pragma once

#include <optional>

#include "base/snapshot.h"
#include "render/frame_passes.h"
#include "render/ready_picture.h"
#include "render/renderer_state.h"

namespace fumon {

/// A picture before its tiles are drawn: what each line of picture_passes() asks and does.
class PictureDrawing {
  public:
    PictureDrawing(RendererState& state, const ReadyPicture& picture);

    /// Before a pass draws.
    void begin(const Pass<PictureDrawing>& /*pass*/) {}

    // Whether a pass is needed. `fresh`: of another bed or light than the textures hold.
    [[nodiscard]] bool always() const { return true; }
    [[nodiscard]] bool of_world() const { return state_.world.has_value(); }
    [[nodiscard]] bool of_block() const { return !state_.world; }
    [[nodiscard]] bool fresh() const { return fresh_; }
    [[nodiscard]] bool fresh_world() const { return fresh_ && of_world(); }
    [[nodiscard]] bool fresh_plants() const { return fresh_ && state_.plants; }
    [[nodiscard]] bool fresh_persons() const { return fresh_ && state_.persons; }
    [[nodiscard]] bool fresh_tracks() const { return fresh_ && state_.tracks; }
    [[nodiscard]] bool with_plants() const { return state_.plants.has_value(); }
    [[nodiscard]] bool with_streamers() const { return state_.streamers.has_value(); }
    [[nodiscard]] bool with_air() const { return state_.air && shown_.section; }

    void upload_bed_maps();
    void upload_world_maps();
    void bind_sky();
    void shade_bed();
    void take_world_mesh();
    void mesh_block();
    void place_plants();
    void place_persons();
    void place_prints();
    void look_at_sun();
    void paint_air();
    void choose_plants();
    void choose_streamers();

  private:
    RendererState& state_;
    const ReadyPicture& picture_;
    const Snapshot& shown_;
    const LitBed& lit_;
    const Camera& camera_;
    std::optional<Snapshot> reference_;  ///< of the pose, from which "change" counts
    bool fresh_ = true;
    std::optional<Field<float>> water_depth_;  ///< over a block, block lengths
};

}  // namespace fumon
