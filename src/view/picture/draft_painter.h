#pragma once

#include <memory>
#include <string>

#include "base/image.h"
#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace fumon {

/// Draws small pictures quickly one after the other: without overlays and blur, one sample a pixel,
/// beds of few cells refined less. What only the camera, the height of the sun or the step change
/// keeps the renderer. Lives on one thread.
class DraftPainter {
  public:
    DraftPainter(gl::Backend backend, WorkerPool& pool) : backend_(backend), pool_(pool) {}
    ~DraftPainter() { close(); }
    DraftPainter(const DraftPainter&) = delete;
    DraftPainter& operator=(const DraftPainter&) = delete;

    /// The picture of the scene at its size of image.width and image.height. Throws as Renderer.
    Image paint(const Scene& scene, const Snapshot& first,
                const std::shared_ptr<const Snapshot>& snapshot);

  private:
    void close();

    gl::Backend backend_;
    WorkerPool& pool_;
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<Renderer> renderer_;
    std::string look_;  ///< of the renderer, all but what may change
    std::shared_ptr<const LitBed> lit_;
};

/// The scene as a draft shows it, at most so many pixels wide and high.
Scene draft_of(Scene scene, int width, int height);

}  // namespace fumon
