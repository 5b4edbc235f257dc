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

/// The visibility buffer of endless ground, in memory that shaders read directly
/// (world/world_position.glsl).
class VisibilityBuffer {
  public:
    /// Whether OpenGL's buffers may be that large.
    [[nodiscard]] static bool holds(const SampleRectangle& samples);

    /// Pixels of the samples, and the bounds that classify them.
    struct Pixels {
        PixelGrid grid;
        pixel_class_vectors::ClassBounds bounds{};
    };

    /// See GroundRasteriser::rasterise(). `in_target`: position of the rectangle's
    /// first sample in the shaders. Without `pixels` no pixel is classified. Throws Error where
    /// OpenGL has no memory, or has lost the contents.
    void rasterise(const GroundTriangles& ground, const Camera& camera,
                   const SampleRectangle& samples, const glm::ivec2& in_target,
                   const std::optional<Pixels>& pixels, WorkerPool& pool);
    [[nodiscard]] const PixelClasses& kinds() const { return kinds_; }

    /// Sets the uniforms with which a program in use reads the buffer, in that texture unit.
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
