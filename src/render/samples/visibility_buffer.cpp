#include "render/samples/visibility_buffer.h"

#include <cstddef>
#include <cstdint>

#include "base/error.h"
#include "gl/functions.h"

namespace fumon {

bool VisibilityBuffer::holds(const SampleRectangle& samples) {
    GLint most = 0;
    gl::functions().GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return samples.count() / 4 <= static_cast<std::size_t>(most);
}

void VisibilityBuffer::rasterise(const GroundTriangles& ground, const Camera& camera,
                                 const SampleRectangle& samples, const glm::ivec2& in_target,
                                 const std::optional<Pixels>& pixels, WorkerPool& pool) {
    samples_ = samples;
    in_target_ = in_target;
    rays_ = sample_rays(camera, samples.picture);
    const gl::Functions& gl = gl::functions();
    const auto bytes = static_cast<GLsizeiptr>(sizeof(std::uint32_t) * samples.count());
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    if (bytes > capacity_) {
        gl.BufferData(GL_TEXTURE_BUFFER, bytes, nullptr, GL_DYNAMIC_DRAW);
        capacity_ = bytes;
        gl.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
        gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffer_.name());
    }
    void* memory =
        gl.MapBufferRange(GL_TEXTURE_BUFFER, 0, bytes, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT);
    if (memory == nullptr) throw Error("OpenGL has no memory for the visibility buffer");
    const auto unmap = [&] { return gl.UnmapBuffer(GL_TEXTURE_BUFFER) == GL_TRUE; };
    try {
        auto* numbers = static_cast<std::uint32_t*>(memory);
        ground_rasteriser_.rasterise(ground, camera, samples, pool, numbers);
        if (pixels) kinds_.classify(numbers, samples, rays_, pixels->grid, pixels->bounds, pool);
    } catch (...) {
        unmap();
        throw;
    }
    if (!unmap()) throw Error("OpenGL has lost the visibility buffer");
}

void VisibilityBuffer::bind(const gl::Program& program, int unit) const {
    const gl::Functions& gl = gl::functions();
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
    program.set("visibility_buffer", unit);
    program.set("buffer_origin", glm::vec2(in_target_));
    program.set("target_begin", glm::vec2(samples_.first - in_target_));
    const auto quads_per_row = samples_.stride() / 4;
    const auto quads = samples_.numbers() / 4;
    program.set("quads_per_row", static_cast<float>(quads_per_row));
    program.set("quads", static_cast<float>(quads));
    program.set("first_ray", glm::vec3(rays_.first));
    program.set("ray_rightward", glm::vec3(rays_.right));
    program.set("ray_upward", glm::vec3(rays_.up));
}

}  // namespace fumon
