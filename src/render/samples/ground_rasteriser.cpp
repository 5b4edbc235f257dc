#include "render/samples/ground_rasteriser.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/worker_pool.h"
#include "render/samples/triangle_clipping.h"

namespace fumon {

namespace {

using visibility_vectors::HorizontalRays;
using visibility_vectors::Perspective;

constexpr int rows_of_band = 16;  // of samples: what they see stays in a cache; even

Perspective projection_of(const Camera& camera, const glm::ivec2& picture) {
    const auto row = [&](const glm::dvec3& way) {
        return visibility_vectors::LinearForm{way.x, way.y, way.z};
    };
    constexpr double parts = 128.0;  // half of the 256 that a sample has
    return {row(parts * picture.x * (camera.right / camera.half.x + camera.forward)),
            row(parts * picture.y * (camera.up / camera.half.y + camera.forward)),
            row(camera.forward), camera.near_depth};
}

ClipPosition clip_position(const Perspective& projection, const glm::dvec3& offset) {
    const auto value = [&](const visibility_vectors::LinearForm& row) {
        return row.x * offset.x + row.y * offset.y + row.z * offset.z;
    };
    return {value(projection.x), value(projection.y), value(projection.depth)};
}

HorizontalRays horizontal_rays(const SampleRays& rays, int row) {
    const auto number = [](double value) { return static_cast<float>(value); };
    const glm::dvec3 first = rays.first + static_cast<double>(row) * rays.up;
    return {number(first.x),      number(first.y),   number(rays.right.x),
            number(rays.right.y), number(rays.up.x), number(rays.up.y)};
}

}  // namespace

SampleRays sample_rays(const Camera& camera, const glm::ivec2& picture) {
    const glm::dvec2 step = 2.0 * camera.half / glm::dvec2(picture);
    const glm::dvec2 first = 0.5 * step - camera.half;
    return {camera.near_depth * (camera.forward + first.x * camera.right + first.y * camera.up),
            camera.near_depth * step.x * camera.right, camera.near_depth * step.y * camera.up};
}

void GroundRasteriser::clip(const GroundTriangles& ground, const Perspective& projection) {
    clipped_vertices_.resize(0);
    const auto add = [&](const std::vector<std::uint32_t>& needing_clipping,
                         std::span<const std::uint32_t> triangles,
                         std::vector<std::uint32_t>& left) {
        left.clear();
        for (const std::uint32_t triangle : needing_clipping) {
            std::array<ClipPosition, 3> vertices;
            for (std::size_t k = 0; k < 3; ++k)
                vertices[k] = clip_position(
                    projection,
                    glm::dvec3(ground.positions[triangles[std::size_t{3} * triangle + k]]));
            add_clipped(vertices, projection.near_depth, clipped_vertices_, left);
        }
    };
    add(bins_.needing_clipping(0), ground.near, clipped_near_);
    add(bins_.needing_clipping(1), ground.far, clipped_far_);
}

void GroundRasteriser::rasterise(const GroundTriangles& ground, const Camera& camera,
                                 const SampleRectangle& samples, WorkerPool& pool,
                                 std::uint32_t* out) {
    const Perspective projection = projection_of(camera, samples.picture);
    vertices_.resize(ground.positions.size());
    pool.for_ranges(static_cast<int>(ground.positions.size()), [&](int begin, int end) {
        visibility_vectors::project_vertices(
            projection, &ground.positions[static_cast<std::size_t>(begin)].x,
            static_cast<std::size_t>(end - begin), vertices_, static_cast<std::size_t>(begin));
    });
    bins_.bin(vertices_, {{ground.near, 0, near_kind, true}, {ground.far, 0, far_kind, true}},
              samples.first.y, samples.size.y, rows_of_band, pool);
    clip(ground, projection);
    clipped_bins_.bin(clipped_vertices_,
                      {{clipped_near_, 0, near_kind, true}, {clipped_far_, 0, far_kind, true}},
                      samples.first.y, samples.size.y, rows_of_band, pool);
    rasterise_bands(camera, samples, pool, out);
}

void GroundRasteriser::rasterise_bands(const Camera& camera, const SampleRectangle& samples,
                                       WorkerPool& pool, std::uint32_t* out) const {
    const SampleRays rays = sample_rays(camera, samples.picture);
    const std::size_t columns = samples.row();
    const std::size_t stride = columns + rasteriser_vectors::Band::beyond;
    const int bands = (samples.size.y + rows_of_band - 1) / rows_of_band;
    std::atomic<int> next = 0;
    pool.for_ranges(pool.size(), [&](int, int) {
        std::vector<std::uint32_t> visibility(stride * rows_of_band +
                                              rasteriser_vectors::Band::beyond);
        std::vector<std::uint32_t> slopes(visibility.size());
        for (int band = next++; band < bands; band = next++) {
            std::fill(visibility.begin(), visibility.end(), 0U);
            const int first = rows_of_band * band;
            const int rows = std::min(rows_of_band, samples.size.y - first);
            const rasteriser_vectors::Band of{visibility.data(),
                                              stride,
                                              samples.first.x,
                                              samples.first.x + samples.size.x,
                                              samples.first.y + first,
                                              samples.first.y + first + rows,
                                              slopes.data()};
            bins_.rasterise(band, vertices_, of);
            clipped_bins_.rasterise(band, clipped_vertices_, of);
            for (int row = 0; row < rows; row += 2) {
                const auto row_of = [&](int i) {
                    const std::size_t from = static_cast<std::size_t>(i) * stride;
                    std::fill(visibility.data() + from + samples.size.x,
                              visibility.data() + from + columns, 0U);
                    return visibility_vectors::VisibilityRow{
                        visibility.data() + from, slopes.data() + from,
                        horizontal_rays(rays, samples.first.y + first + i)};
                };
                std::uint32_t* numbers = out + samples.index(0, static_cast<std::size_t>(first) +
                                                                    static_cast<std::size_t>(row));
                visibility_vectors::record_rows(row_of(row), row_of(row + 1),
                                                static_cast<float>(samples.first.x), columns,
                                                numbers, numbers + samples.numbers());
            }
        }
    });
}

}  // namespace fumon
