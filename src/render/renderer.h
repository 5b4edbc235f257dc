#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "base/snapshot.h"
#include "render/colour/colouring.h"
#include "render/colour/pixel_format.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

namespace gl {
class Context;
}
class WorkerPool;

/// What a film changes from frame to frame.
struct FramePose {
    Camera camera;          ///< in the block of the view, see framed_block()
    SunSettings sun;        ///< of which the azimuth and the elevation count
    double exposure = 0.0;  ///< stops, besides look.exposure
    double share = 0.0;     ///< of the run, for clouds that drift over it
    /// Reference bed of look.colour_by = "change", of the same size; none: the first bed.
    std::shared_ptr<const Snapshot> reference{};
    /// Number of moves of the streamers by streamers.travel; none: the snapshot's
    /// step.
    std::optional<std::int64_t> frame{};
    /// Camera whose view of the sky sets the exposure, see exposure_under_sky(): one exposure for
    /// a run, and for a film's shot. None: the picture's own.
    std::optional<Camera> metered{};
};

class FloatPicture;
class AccumulatedLight;
struct LitBed;
struct ReadyPicture;
struct RendererState;
struct Tile;

/// How much is drawn at once.
struct RenderLimits {
    int tile_samples = 4096;    ///< samples along each side of the largest tile
    bool draft = false;         ///< beds of few cells are refined less
    bool one_picture = false;   ///< what only later ones gain from is left out
    bool pixels_alike = false;  ///< those of water are shaded as if each might show anything
};

/// Turns snapshots into pictures of one view. Everything that must not change during a run
/// (framing, automatic exaggeration, the reference of "change") is taken from the first snapshot,
/// so that a still of step n equals the run's frame of step n. Used on the thread of its context
/// only.
class Renderer {
  public:
    /// `last_step` is the run's length, over which the camera turns. Throws InputError where the
    /// view does not fit the bed (a palette that does not exist), Error where OpenGL fails.
    Renderer(gl::Context& context, const View& view, const Snapshot& first, std::int64_t last_step,
             WorkerPool& pool, const RenderLimits& limits = {},
             PixelFormat kind = PixelFormat::display_8);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// The picture of one snapshot. Its bed has the size of the first one. Of a renderer of display
    /// values.
    Image render(const Snapshot& snapshot);
    /// What the picture of a snapshot from another point and in another light needs besides OpenGL,
    /// found on any thread, also while this draws. The light of `before`, of an earlier picture or
    /// none, is taken where bed and sun are the same.
    [[nodiscard]] ReadyPicture ready(std::shared_ptr<const Snapshot> snapshot,
                                     const FramePose& pose,
                                     const std::shared_ptr<const LitBed>& before,
                                     WorkerPool& pool) const;
    /// That picture. Later ones keep its light.
    Image render(const ReadyPicture& picture);

    /// The same as radiances, of which 1 is near that of a white level plain in the sun: the
    /// channels R, G, B and, where the background is transparent, A, by which they are multiplied;
    /// with `positions` those of SurfacePositionLayers too. Of a renderer of radiances.
    LayeredImage render_layers(const Snapshot& snapshot, bool positions);

    /// The radiances of a picture from another point and in another light, as render() draws it.
    LayeredImage render_light(const ReadyPicture& picture);

    /// The vertical exaggeration in use.
    [[nodiscard]] double exaggeration() const;
    /// Keeps the colours of the first picture whose values differ for all later ones, unless
    /// look.range is "frame".
    void keep_colours();
    /// The camera of the last picture of a snapshot on endless ground of a bed that ends: where it
    /// stands or looks beside the bed, its heights are those of the land there. None elsewhere.
    [[nodiscard]] const std::optional<Camera>& camera_on_land() const { return on_land_; }
    /// The colours of the last picture.
    [[nodiscard]] const FrameColourRange& frame_colour_range() const;

  private:
    [[nodiscard]] ReadyPicture ready_at_step(const Snapshot& snapshot) const;
    /// For a run during which the sun wanders or clouds drift.
    void prepare_sky(const ReadyPicture& picture);
    void prepare(const ReadyPicture& picture);
    /// The same in the light of its pose.
    void prepare_pose(const ReadyPicture& picture);
    [[nodiscard]] LayeredImage radiances(const ReadyPicture& picture);
    Image draw(const ReadyPicture& picture);
    /// The same through the lens.
    Image draw_through_lens(const ReadyPicture& picture);
    [[nodiscard]] FloatPicture draw_deep(const Camera& camera);
    [[nodiscard]] std::vector<ImageLayer> draw_radiances(const ReadyPicture& picture);
    [[nodiscard]] std::vector<ImageLayer> draw_positions(const ReadyPicture& picture);
    /// What a tile's pixels get of the light through some points of the lens. Only what depends on
    /// the place of these in the picture is drawn anew for each: ground and light are the eye's, as
    /// Cook, Carpenter & Catmull (1987) shade before they sample a lens.
    [[nodiscard]] AccumulatedLight gather_light(const Tile& tile, const ReadyPicture& picture);

    std::unique_ptr<RendererState> state_;
    std::optional<Camera> on_land_;
};

}  // namespace fumon
