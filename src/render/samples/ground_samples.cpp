#include "render/samples/ground_samples.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/worker_pool.h"
#include "render/samples/cut_triangles.h"

namespace fumon {

namespace {

using seen_vectors::LevelRays;
using seen_vectors::Perspective;

constexpr int rows_of_band = 16;  // of samples: what they see stays in a cache; even

Perspective projection_of(const Camera& camera, const glm::ivec2& picture) {
    const auto row = [&](const glm::dvec3& way) { return seen_vectors::Row{way.x, way.y, way.z}; };
    constexpr double parts = 128.0;  // half of the 256 that a sample has
    return {row(parts * picture.x * (camera.right / camera.half.x + camera.forward)),
            row(parts * picture.y * (camera.up / camera.half.y + camera.forward)),
            row(camera.forward), camera.near_depth};
}

DeepPlace place_of(const Perspective& projection, const glm::dvec3& offset) {
    const auto value = [&](const seen_vectors::Row& row) {
        return row.x * offset.x + row.y * offset.y + row.z * offset.z;
    };
    return {value(projection.x), value(projection.y), value(projection.depth)};
}

LevelRays level_rays(const SampleRays& rays, int row) {
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

void GroundSamples::cut(const GroundTriangles& ground, const Perspective& projection) {
    cut_corners_.resize(0);
    const auto add = [&](const std::vector<std::uint32_t>& unplaced,
                         std::span<const std::uint32_t> triangles,
                         std::vector<std::uint32_t>& left) {
        left.clear();
        for (const std::uint32_t triangle : unplaced) {
            std::array<DeepPlace, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] =
                    place_of(projection,
                             glm::dvec3(ground.places[triangles[std::size_t{3} * triangle + k]]));
            add_cut(corners, projection.near_depth, cut_corners_, left);
        }
    };
    add(bands_.unplaced(0), ground.near, cut_near_);
    add(bands_.unplaced(1), ground.far, cut_far_);
}

void GroundSamples::see(const GroundTriangles& ground, const Camera& camera,
                        const SampleRectangle& samples, WorkerPool& pool, std::uint32_t* out) {
    const Perspective projection = projection_of(camera, samples.picture);
    corners_.resize(ground.places.size());
    pool.for_ranges(static_cast<int>(ground.places.size()), [&](int begin, int end) {
        seen_vectors::place_corners(projection, &ground.places[static_cast<std::size_t>(begin)].x,
                                    static_cast<std::size_t>(end - begin), corners_,
                                    static_cast<std::size_t>(begin));
    });
    bands_.sort(corners_, {{ground.near, 0, near_kind, true}, {ground.far, 0, far_kind, true}},
                samples.first.y, samples.size.y, rows_of_band, pool);
    cut(ground, projection);
    cut_bands_.sort(cut_corners_, {{cut_near_, 0, near_kind, true}, {cut_far_, 0, far_kind, true}},
                    samples.first.y, samples.size.y, rows_of_band, pool);
    draw(camera, samples, pool, out);
}

void GroundSamples::draw(const Camera& camera, const SampleRectangle& samples, WorkerPool& pool,
                         std::uint32_t* out) const {
    const SampleRays rays = sample_rays(camera, samples.picture);
    const std::size_t columns = samples.row();
    const std::size_t stride = columns + triangle_vectors::Band::beyond;
    const int bands = (samples.size.y + rows_of_band - 1) / rows_of_band;
    std::atomic<int> next = 0;
    pool.for_ranges(pool.size(), [&](int, int) {
        std::vector<std::uint32_t> seen(stride * rows_of_band + triangle_vectors::Band::beyond);
        std::vector<std::uint32_t> slopes(seen.size());
        for (int band = next++; band < bands; band = next++) {
            std::fill(seen.begin(), seen.end(), 0U);
            const int first = rows_of_band * band;
            const int rows = std::min(rows_of_band, samples.size.y - first);
            const triangle_vectors::Band of{seen.data(),
                                            stride,
                                            samples.first.x,
                                            samples.first.x + samples.size.x,
                                            samples.first.y + first,
                                            samples.first.y + first + rows,
                                            slopes.data()};
            bands_.draw(band, corners_, of);
            cut_bands_.draw(band, cut_corners_, of);
            for (int row = 0; row < rows; row += 2) {
                const auto row_of = [&](int i) {
                    const std::size_t from = static_cast<std::size_t>(i) * stride;
                    std::fill(seen.data() + from + samples.size.x, seen.data() + from + columns,
                              0U);
                    return seen_vectors::SeenRow{seen.data() + from, slopes.data() + from,
                                                 level_rays(rays, samples.first.y + first + i)};
                };
                std::uint32_t* numbers = out + samples.place(0, static_cast<std::size_t>(first) +
                                                                    static_cast<std::size_t>(row));
                seen_vectors::note_rows(row_of(row), row_of(row + 1),
                                        static_cast<float>(samples.first.x), columns, numbers,
                                        numbers + samples.numbers());
            }
        }
    });
}

}  // namespace fumon
