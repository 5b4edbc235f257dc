#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/image.h"
#include "base/snapshot.h"
#include "gl/context.h"
#include "measure/measured_rows.h"
#include "picture/environment.h"
#include "render/colour/colouring.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// The renderer and its settings, for the manifest and the pictures.
struct DrawingRecord {
    RenderingEnvironment environment;  ///< its backend is empty where nothing was drawn
    std::string pinning_obstacle;      ///< empty where it is, or where that was not asked for
    double exaggeration = 1.0;
    std::string text_library;  ///< that writes on the frames; empty where there is no text
    /// SHA-256 of the pixels before overlays were laid over them, hexadecimal, of one picture;
    /// empty where it has no overlays.
    std::string under_overlays{};
};

/// Why a picture with text is not pinned.
inline constexpr const char* text_is_not_pinned = "its text is set in the system's fonts";

/// Draws the frames of a run: the view of the bed, or the flat figure of a section if look.mode is
/// "figure" and the model has a section (this needs no OpenGL). The scene's overlays are drawn on
/// top. Pixels of a section's figure and of overlays depend on the system's fonts and on the
/// versions of the text libraries. Lives on one thread.
class FramePainter {
  public:
    virtual ~FramePainter() = default;
    /// The frame of a snapshot; `rows` are the measurements up to it that plots show.
    virtual Image paint(const Snapshot& snapshot, const MeasuredRows& rows) = 0;
    /// Its light and layers, without overlays, where they were asked for.
    virtual LayeredImage paint_layers(const Snapshot& snapshot) = 0;
    /// Before the first of a run's frames: see Renderer::keep_colours().
    virtual void keep_colours() {}
    /// See Renderer::camera_on_land().
    [[nodiscard]] virtual std::optional<Camera> camera_on_land() const { return {}; }
    /// The colours of the last frame, where it has one palette.
    [[nodiscard]] virtual FrameColourRange frame_colour_range() const { return {}; }
    [[nodiscard]] virtual DrawingRecord record() const = 0;
};

/// What a painter is asked for.
enum class PaintedContent { pictures, one_picture, pictures_and_layers, layers };

/// Throws KeyError where a view has no light that layers could hold, or where they would take more
/// than 16 GiB.
void check_layers(const Scene& scene, const Snapshot& first);

/// The painter of a scene's view, framed by its first snapshot. Throws InputError where the view
/// does not fit the bed, KeyError where the section's keys or the overlays do not, Error where
/// OpenGL fails.
std::unique_ptr<FramePainter> make_frame_painter(const Scene& scene, const Snapshot& first,
                                                 gl::Backend backend, WorkerPool& pool,
                                                 PaintedContent frames = PaintedContent::pictures);

}  // namespace fumon
