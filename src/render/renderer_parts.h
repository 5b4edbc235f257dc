#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "gl/mipmaps.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/air/air_layer.h"
#include "render/background/background_layer.h"
#include "render/bed/bed_shading.h"
#include "render/block/terrain_layer.h"
#include "render/byte_picture.h"
#include "render/frame/sample_targets.h"
#include "render/lens/lens_tone.h"
#include "render/life/person_layer.h"
#include "render/life/plant_layer.h"
#include "render/life/track_layer.h"
#include "render/light/light.h"
#include "render/position/surface_position_layers.h"
#include "render/position/surface_position_pass.h"
#include "render/ready_picture.h"
#include "render/renderer.h"
#include "render/samples/block_samples.h"
#include "render/samples/deep_picture.h"
#include "render/samples/gathered_light.h"
#include "render/samples/packed_samples.h"
#include "render/streamers/streamer_layer.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/drawn_origin.h"
#include "render/view/far_copies.h"
#include "render/view/lens.h"
#include "render/view/plain_around.h"
#include "render/view/tiles.h"
#include "render/water/water_pixels.h"
#include "render/world/world_layer.h"

namespace fumon {

/// What a renderer keeps, and how it draws a tile with it.
struct Renderer::Parts {
    Parts(gl::Context& context_, const View& view_, const Snapshot& first_, std::int64_t last_step_,
          WorkerPool& pool_, const RenderLimits& limits, PixelKind kind_);

    /// The first snapshot as it is shown.
    [[nodiscard]] static Snapshot shown_first(const Snapshot& first, const View& view);
    /// The first snapshot as the ground's maps hold it.
    [[nodiscard]] const Snapshot& first_ground() const {
        return first_in_plain ? *first_in_plain : first;
    }
    [[nodiscard]] Camera camera_at(std::int64_t step) const;
    /// A tile's first sample, and the sample its target begins at; from the picture's lower left.
    [[nodiscard]] glm::ivec2 first_sample(const Tile& tile) const;
    [[nodiscard]] glm::ivec2 target_corner(const Tile& tile) const;
    void set_light(const FramePose& pose);
    /// For a run during which the sun wanders or clouds drift.
    void follow_sky(const FramePose& pose);
    /// How much of it the camera sees, for its glare.
    void see_sun(const ReadyPicture& picture);
    [[nodiscard]] std::shared_ptr<const LitBed> lit_bed(const ReadyPicture& picture,
                                                        const SunDirection& sun,
                                                        WorkerPool& with) const;
    [[nodiscard]] ReadyPicture ready(std::shared_ptr<const Snapshot> snapshot,
                                     const SunDirection& sun, const std::optional<FramePose>& pose,
                                     const std::shared_ptr<const LitBed>& before,
                                     WorkerPool& with) const;
    [[nodiscard]] bool open() const { return view.look.background == Background::transparent; }
    [[nodiscard]] bool lens() const { return view.camera.has_lens(); }
    [[nodiscard]] TileSamples placed_samples(const Tile& tile) const;
    /// Whether pixels of the block get their colours as wholes: 8 bits of it alone, in the scenic
    /// look. Maps stay what they are.
    [[nodiscard]] bool coloured_by_pixels(const Camera& camera) const;
    /// Before a picture's tiles are drawn by draw_block().
    void read_block_colours();
    /// Of the water that a picture shows.
    void find_water_kinds(const DisplayWater& standing, const Snapshot& shown);
    /// The pixels of a block with water, as far as they show its surface.
    void shade_block_pixels(const Tile& tile, const Camera& camera, Image& image);
    void draw_block(const Tile& tile, const Camera& camera, Image& image);
    void draw_block_sides(const Tile& tile, const Camera& camera);
    /// Whether nothing stands on endless ground, so that samples of edges alone need colours.
    [[nodiscard]] bool packs_samples() const {
        return pixels && kind == PixelKind::display_8 && !air && !plants && !persons && !tracks;
    }
    /// Where the pixels of a tile of endless ground lie among samples.
    [[nodiscard]] PixelSamples pixel_samples(const Tile& tile, const Camera& camera) const;
    /// Colours pixels of endless ground that see one place each.
    void shade_pixels(const PixelSamples& at, const Camera& camera);
    /// What each sample of a tile sees; in a target, if others than the ground want to know.
    void see_ground(const Tile& tile, const Camera& camera);
    /// After see_ground(): what lies before it.
    void see_streamers(const Tile& tile, const Camera& camera);
    void draw_packed_samples(const Tile& tile, const Camera& camera);
    void draw_samples(const Tile& tile, const Camera& camera);
    void draw_tile(const Tile& tile, const Camera& camera, Image& image);
    void draw_tile(const Tile& tile, const Camera& camera, DeepPicture& picture);
    void rasterise_positions(const Tile& tile, const Camera& camera, SurfacePositionLayers& layers);
    [[nodiscard]] DeepPicture deep_picture(const Camera& camera);
    [[nodiscard]] RayGround ground_for_rays(const ReadyPicture& picture) const;
    /// Of the sun's disc, that the ground leaves to the camera.
    [[nodiscard]] double sun_share(const ReadyPicture& picture) const;
    /// Gives the camera its lens, and says through how many points of it the picture is seen.
    void set_lens(ReadyPicture& picture, bool posed) const;
    void draw_behind_samples(const Tile& tile, const Camera& camera);
    /// What a tile's pixels get of the light through some points of the lens. Only what depends on
    /// the place of these in the picture is drawn anew for each: ground and light are the eye's, as
    /// Cook, Carpenter & Catmull (1987) shade before they sample a lens.
    [[nodiscard]] GatheredLight gathered_light(const Tile& tile, const Camera& camera,
                                               int lens_points_wanted);
    [[nodiscard]] Image lens_picture(const Camera& camera, int lens_points_wanted);
    [[nodiscard]] std::vector<ImageLayer> lens_channels(const Camera& camera,
                                                        int lens_points_wanted);
    void draw_background(const Tile& tile, const Camera& camera, DeepPicture* deep);
    /// The same after draw_samples() or BlockSamples::see(), and only where these left pixels that
    /// do not see the ground alone; the whole of it, for the next ones, of the first of several
    /// pictures and where the camera is the last one's.
    void draw_uncovered_background(const Tile& tile, const Camera& camera);
    [[nodiscard]] const gl::RenderTarget& surroundings();
    [[nodiscard]] GroundTransform plant_ground(const Camera& camera) const;
    [[nodiscard]] Field<float> drawn_surface(const ReadyPicture& picture) const;
    /// In block lengths: water over a bed of the snapshot, and the surface of both.
    [[nodiscard]] Field<float> drawn_depth(const DisplayWater& standing,
                                           const Snapshot& shown) const;
    [[nodiscard]] Field<float> surface_of(const DisplayBed& bed, const DisplayWater& standing,
                                          const Snapshot& shown) const;

    gl::Context& context;
    View view;
    Snapshot first;
    std::int64_t last_step;
    WorkerPool& pool;
    PixelKind wanted;
    PixelKind kind;  // in which samples are drawn
    Block block;
    std::optional<PlainAround> plain;  // of endless ground that is not the bed's own repetition
    std::optional<Snapshot> first_in_plain;
    Block ground;  // the block of its maps
    bool water;    // whether it is drawn
    int refinement;
    DrawnOrigin origin;  // of endless ground
    FarCopies copies;    // likewise
    TilePlan plan;
    Light light;
    bool atmosphere;         // of the light's sky
    Light light_before;      // of the sun before this one, to which a cross-fade comes back
    SunSettings sun_before;  // with it
    gl::Constants fixed;
    gl::Texture2D sky;
    gl::MipmapMaker mipmaps;
    BedShading shading;
    std::optional<WaterPixels> water_pixels;  // where the ground of a block is shaded by pixels
    std::shared_ptr<const LitBed> uploaded;   // which the textures hold
    TerrainLayer terrain;
    BackgroundLayer background;
    std::optional<AirLayer> air;
    std::optional<WorldLayer> world;  // where the bed is endless
    std::optional<PlantLayer> plants;
    std::optional<PersonLayer> persons;
    std::optional<TrackLayer> tracks;
    std::optional<StreamerLayer> streamers;
    std::optional<SurfacePositionPass> places;
    std::optional<SampleTargets> sampled;
    std::optional<BlockSamples> block_samples;
    BlockColours block_colours;          // room for the next ones
    PixelPlaces block_places;            // room for those of a block with water
    place_vectors::KindMap water_kinds;  // of the picture's
    bool block_coloured = false;         // whether block_samples has those of the picture
    std::optional<gl::DepthBuffer> pixel_depths;
    std::optional<gl::RenderTarget> pixels;  // of endless ground, those that see one place each
    std::optional<PackedSamples> packed;     // and samples of the others
    std::optional<gl::RenderTarget> surroundings_target;
    gl::VertexArray no_attributes;
    bool one_picture;
    bool later_pictures;                      // of the same camera, perhaps
    std::optional<Camera> surroundings_from;  // of the light of now, for the one tile
    bool surroundings_whole = false;          // also where the ground covers them
    BytePicture bytes;
    std::optional<LensTone> lens_tone;
};

}  // namespace fumon
