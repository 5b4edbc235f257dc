#pragma once

#include <memory>
#include <string>

#include "gl/context.h"
#include "models/model.h"
#include "output/environment.h"
#include "render/image.h"
#include "scene/scene.h"

namespace fumon {

class WorkerPool;

/// What drew, for the manifest and the pictures.
struct DrawingRecord {
    RenderingEnvironment environment;  ///< its backend is empty where nothing was drawn
    std::string why_not_pinned;        ///< empty where it is, or where that was not asked for
    double exaggeration = 1.0;
};

/// Draws the frames of a run: a section's flat figure where look.mode is "figure" and the model has
/// a section, which needs no OpenGL, else the view of the bed. Pixels of a section's figure depend
/// on the system's fonts and on the versions of the text libraries. Lives on one thread.
class FramePainter {
  public:
    virtual ~FramePainter() = default;
    virtual Image paint(const Snapshot& snapshot) = 0;
    [[nodiscard]] virtual DrawingRecord record() const = 0;
};

/// The painter of a scene's view, framed by its first snapshot. Throws InputError where the view
/// does not fit the bed, KeyError where the section's keys do not, Error where OpenGL fails.
std::unique_ptr<FramePainter> make_frame_painter(const Scene& scene, const Snapshot& first,
                                                 gl::Backend backend, WorkerPool& pool);

}  // namespace fumon
