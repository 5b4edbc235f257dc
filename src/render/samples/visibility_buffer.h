#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "gl/handles.h"
#include "gl/program.h"
#include "render/samples/ground_rasteriser.h"
#include "render/samples/pixel_classes.h"
#include "render/view/camera.h"

namespace fumon {

class WorkerPool;

/// What samples see of endless ground, in memory that shaders read as it is
/// (world/world_position.glsl).
class VisibilityBuffer {
  public:
    /// Whether OpenGL's buffers may be that large.
    [[nodiscard]] static bool holds(const SampleRectangle& samples);

    /// Pixels of the samples, and what tells them apart.
    struct Pixels {
        PixelGrid grid;
        pixel_class_vectors::ClassBounds bounds{};
    };

    /// See GroundRasteriser::rasterise(). `in_target`: where the shaders count the rectangle's
    /// first sample. Without `pixels` their kinds are not told. Throws Error where OpenGL gives no
    /// memory, or has lost what was written.
    void rasterise(const GroundTriangles& ground, const Camera& camera,
                   const SampleRectangle& samples, const glm::ivec2& in_target,
                   const std::optional<Pixels>& pixels, WorkerPool& pool);
    [[nodiscard]] const PixelClasses& kinds() const { return kinds_; }

    /// Sets what a program in use needs to look it up, in that texture unit.
    void bind(const gl::Program& program, int unit) const;

  private:
    GroundRasteriser ground_rasteriser_;
    PixelClasses kinds_;
    gl::Buffer buffer_;
    gl::Texture texture_;
    GLsizeiptr capacity_ = 0;  // bytes
    SampleRectangle samples_;
    glm::ivec2 in_target_{0};
    SampleRays rays_{};
};

}  // namespace fumon
