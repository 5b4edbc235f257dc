#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/snapshot.h"
#include "render/ground/ground_fan.h"
#include "render/ground/height_pyramid.h"
#include "render/light/light_texels.h"
#include "render/light/repeated_light.h"
#include "render/light/sun_sweep.h"
#include "render/renderer.h"
#include "render/streamers/blown_sand.h"
#include "render/view/block.h"
#include "render/view/display_bed.h"
#include "render/view/water.h"

namespace fumon {

/// A bed and what the light of a sun does to it, as textures take them.
struct LitBed {
    std::shared_ptr<const Snapshot> snapshot;
    SunDirection sun;
    DisplayBed bed;                      ///< of a block
    LightTexels texels;                  ///< likewise, see lighting_texels()
    std::optional<DisplayWater> water;   ///< where it is drawn: of a block, or of `water_tile`
    RepeatedLight light;                 ///< of endless ground, without its heights
    std::optional<Snapshot> in_plain;    ///< the bed as the ground's maps hold it, where it ends
    std::optional<Snapshot> water_tile;  ///< likewise, the bed's own tile alone, where it has water
    std::shared_ptr<const HeightPyramid> heights;
    std::optional<BlownSand> blown;  ///< where it is drawn
};

/// All that a picture needs besides OpenGL, see Renderer::ready().
struct ReadyPicture {
    std::shared_ptr<const Snapshot> snapshot;
    std::optional<Snapshot> reshaped;  ///< as it is shown, where that differs
    FramePose pose;
    Block framed;
    std::shared_ptr<const LitBed> lit;
    VisibleGround ground;    ///< of endless ground
    double sun_share = 1.0;  ///< of the sun's disc, that the ground leaves to the camera
    int lens_points = 1;     ///< through which it is seen

    [[nodiscard]] const Snapshot& shown() const { return reshaped ? *reshaped : *snapshot; }
    /// What the ground's maps hold.
    [[nodiscard]] const Snapshot& ground_shown() const {
        return lit->in_plain ? *lit->in_plain : shown();
    }
};

}  // namespace fumon
