#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/air/air_layer.h"
#include "render/background/background_pass.h"
#include "render/bed/bed_shading.h"
#include "render/block/block_passes.h"
#include "render/block/terrain_layer.h"
#include "render/byte_picture.h"
#include "render/frame/frame_targets.h"
#include "render/frame/ground_transform.h"
#include "render/frame_setting.h"
#include "render/lens/lens_tone.h"
#include "render/life/person_layer.h"
#include "render/life/plant_layer.h"
#include "render/life/track_layer.h"
#include "render/light/light.h"
#include "render/position/surface_position_pass.h"
#include "render/ready_picture.h"
#include "render/renderer.h"
#include "render/samples/block_rasteriser.h"
#include "render/samples/packed_samples.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/camera.h"
#include "render/view/lens.h"
#include "render/water/water_block_pass.h"
#include "render/world/world_layer.h"

namespace fumon {

/// What a renderer keeps from picture to picture: the light, targets, and the layers that its
/// passes draw. Most are made only where its view needs them.
struct RendererState : FrameSetting {
    /// As Renderer().
    RendererState(gl::Context& context_, const View& view_, const Snapshot& first_,
                  std::int64_t last_step_, WorkerPool& pool_, const RenderLimits& limits,
                  PixelFormat kind_);

    /// For another sun, and clouds that drift.
    void set_light(const FramePose& pose);
    /// How the ground is rasterised for a camera.
    [[nodiscard]] GroundTransform ground_transform(const Camera& camera) const;
    /// Whether all that is drawn is a block whose pixels vector code can rasterise, see
    /// block_passes(); of a picture of 8 bits.
    [[nodiscard]] bool drawn_by_block_passes(const Camera& camera) const;

    // What needs no OpenGL, and reads nothing that drawing changes: see Renderer::ready().
    [[nodiscard]] ReadyPicture ready(std::shared_ptr<const Snapshot> snapshot,
                                     const SunDirection& sun, const std::optional<FramePose>& pose,
                                     const std::shared_ptr<const LitBed>& before,
                                     WorkerPool& with) const;
    /// Of the sun's disc, that the ground leaves to the camera.
    [[nodiscard]] double sun_share(const ReadyPicture& picture) const;
    /// The surface as it is drawn, water included.
    [[nodiscard]] Field<float> drawn_surface(const ReadyPicture& picture) const;
    /// Water over a bed of the snapshot, block lengths.
    [[nodiscard]] Field<float> drawn_depth(const DisplayWater& standing,
                                           const Snapshot& shown) const;

    gl::Context& context;
    WorkerPool& pool;

    Light light;
    bool atmosphere;         ///< of the light's sky
    Light light_before;      ///< of the sun before this one, to which a cross-fade comes back
    SunSettings sun_before;  ///< with it

    gl::Constants fixed;
    gl::Texture2D sky;
    gl::MipmapMaker mipmaps;
    gl::VertexArray no_attributes;
    FrameTargets targets;

    BedShading shading;
    std::shared_ptr<const LitBed> uploaded;  ///< which the textures hold
    TerrainLayer terrain;
    std::optional<BlockRasteriser> coverage;
    DryBlockPass dry_block;
    std::optional<WaterBlockPass> water_block;  ///< where its ground is shaded by pixels
    std::optional<WorldLayer> world;            ///< where the bed is endless
    std::optional<PackedSamples> edges;
    std::optional<TrackLayer> tracks;
    std::optional<PlantLayer> plants;
    std::optional<PersonLayer> persons;
    std::optional<AirLayer> air;
    std::optional<StreamerLayer> streamers;
    BackgroundPass background;
    std::optional<SurfacePositionPass> positions;
    std::optional<LensTone> lens_tone;
    BytePicture bytes;
    bool one_picture;

  private:
    [[nodiscard]] std::shared_ptr<const LitBed> lit_bed(const ReadyPicture& picture,
                                                        const SunDirection& sun,
                                                        WorkerPool& with) const;
    [[nodiscard]] RayGround ground_for_rays(const ReadyPicture& picture) const;
    /// Gives the camera its lens, and says through how many points of it the picture is seen.
    void set_lens(ReadyPicture& picture, bool posed) const;
    /// Of a bed and the water over it.
    [[nodiscard]] Field<float> surface_of(const DisplayBed& bed, const DisplayWater& standing,
                                          const Snapshot& shown) const;
};

}  // namespace fumon
