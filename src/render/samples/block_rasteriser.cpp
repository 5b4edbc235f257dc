#include "render/samples/block_rasteriser.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/worker_pool.h"
#include "render/samples/triangle_clipping.h"

namespace fumon {

namespace {

using block_vectors::AffineFunction;
using block_vectors::EdgePixels;
using rasteriser_vectors::Band;

/// A row of a matrix, for places 0 … 1 over the block.
AffineFunction over_block(const glm::dmat4& matrix, int row, const glm::dvec2& extent) {
    const double east = matrix[0][row] * extent.x;
    const double north = matrix[1][row] * extent.y;
    return {east, north, matrix[2][row], matrix[3][row] - 0.5 * (east + north)};
}

AffineFunction sum(const AffineFunction& a, const AffineFunction& b, double factor_of_both) {
    return {factor_of_both * (a.east + b.east), factor_of_both * (a.north + b.north),
            factor_of_both * (a.height + b.height), factor_of_both * (a.constant + b.constant)};
}

/// Where corners stand among so many samples.
block_vectors::VertexProjection vertex_projection(const Camera& camera, const glm::dvec2& extent,
                                                  const glm::ivec2& samples) {
    const glm::dmat4 matrix = clip_matrix(camera);
    const AffineFunction depth = over_block(matrix, 3, extent);
    constexpr double parts = 128.0;  // half of the 256 that a sample has
    block_vectors::VertexProjection projection{
        sum(over_block(matrix, 0, extent), depth, parts * samples.x),
        sum(over_block(matrix, 1, extent), depth, parts * samples.y),
        {0.0, 0.0, 0.0, camera.near_depth},
        depth,
        camera.perspective ? camera.near_depth : 0.5};
    if (!camera.perspective) {
        const double range = camera.far_depth - camera.near_depth;
        const double east = -camera.forward.x * extent.x / range;
        const double north = -camera.forward.y * extent.y / range;
        const double from_eye = camera.far_depth + glm::dot(camera.forward, camera.eye);
        projection.reversed_z = {east, north, -camera.forward.z / range,
                                 from_eye / range - 0.5 * (east + north)};
    }
    return projection;
}

/// How places along one axis, of which `first` is 0, follow from reversed z in a row of samples.
block_vectors::Rays rays_of(const Camera& camera, int axis, double first, double extent, int row,
                            const glm::ivec2& samples) {
    const double y = 2.0 * (row + 0.5) / samples.y - 1.0;
    const double left = -camera.half.x * camera.right[axis];
    const double aside = (left + y * camera.half.y * camera.up[axis]) / extent;
    const double by_column = -2.0 * left / (samples.x * extent);
    const double origin = camera.eye[axis] / extent - first / extent;
    const double ahead = camera.forward[axis] / extent;
    if (camera.perspective)
        return {static_cast<float>(origin), 0.0F, static_cast<float>(ahead + aside),
                static_cast<float>(by_column)};
    return {static_cast<float>(origin + aside), static_cast<float>(by_column),
            static_cast<float>(ahead), 0.0F};
}

block_vectors::Depths depths_of(const Camera& camera) {
    return {camera.perspective, static_cast<float>(camera.near_depth),
            static_cast<float>(camera.far_depth),
            static_cast<float>(camera.near_depth - camera.far_depth)};
}

}  // namespace

BlockRasteriser::Scratch::Scratch(int pixels)
    : stride(static_cast<std::size_t>(factor * pixels) + Band::beyond),
      samples(stride * factor * band_rows + Band::beyond),
      planes(pixels),
      state(static_cast<std::size_t>(pixels) + Band::beyond) {
    edges.allocate(pixels);
    listed.allocate(pixels);
}

void BlockRasteriser::set_texture(glm::vec2 grain_texels, BlockTexture& read) {
    grain_texels_ = grain_texels;
    if (grain_ > 0.0F && packed_grain_.empty()) packed_grain_ = block_vectors::packed_grain();
    std::swap(colours_, read);
}

void BlockRasteriser::set_up_triangles(const BlockMesh& shape, const Camera& camera,
                                       const glm::ivec2& picture, WorkerPool& pool) {
    samples_ = factor * picture;
    first_sample_ = factor * glm::ivec2(tile_.x, picture.y - tile_.y - tile_.height);
    const block_vectors::VertexProjection projection =
        vertex_projection(camera, shape.extent, samples_);
    const std::size_t surface = shape.surface.heights.size();
    const std::size_t sides = shape.sides.heights.size();
    vertices_.resize(surface + sides);
    block_vectors::project_vertices(projection, shape.surface.positions.data(),
                                    shape.surface.heights.data(), surface, vertices_, 0);
    block_vectors::project_vertices(projection, shape.sides.positions.data(),
                                    shape.sides.heights.data(), sides, vertices_, surface);
    std::vector<TriangleGroup> parts{
        {shape.surface_triangles, 0, block_vectors::surface_kind, shape.double_sided}};
    for (std::size_t side = 0; side < shape.side_triangles.size(); ++side)
        parts.push_back({shape.side_triangles[side], surface,
                         static_cast<std::uint32_t>(first_side + side), shape.double_sided});
    bins_.bin(vertices_, parts, first_sample_.y, factor * tile_.height, factor * band_rows, pool);
    clipped_vertices_.resize(0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        TriangleGroup& part = parts[p];
        clipped_[p].clear();
        const BlockMesh::Vertices& vertices = p == 0 ? shape.surface : shape.sides;
        for (const std::uint32_t triangle : bins_.needing_clipping(p)) {
            std::array<ClipPosition, 3> positions{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t corner = part.triangles[std::size_t{3} * triangle + k];
                const double east = vertices.positions[std::size_t{2} * corner];
                const double north = vertices.positions[std::size_t{2} * corner + 1];
                const double height = vertices.heights[corner];
                const auto value = [&](const AffineFunction& of) {
                    return of.east * east + of.north * north + of.height * height + of.constant;
                };
                positions[k] = {value(projection.x), value(projection.y), value(projection.depth)};
            }
            add_clipped(positions, projection.least_depth, clipped_vertices_, clipped_[p]);
        }
        part.triangles = clipped_[p];
        part.first_vertex = 0;
    }
    clipped_bins_.bin(clipped_vertices_, std::move(parts), first_sample_.y, factor * tile_.height,
                      factor * band_rows, pool);
}

void BlockRasteriser::rasterise_band(int band, Scratch& scratch) const {
    const int first_row = first_sample_.y + factor * band_rows * band;
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    std::fill(scratch.samples.begin(), scratch.samples.end(), 0U);
    const Band of{scratch.samples.data(),
                  scratch.stride,
                  first_sample_.x,
                  first_sample_.x + factor * tile_.width,
                  first_row,
                  first_row + factor * rows};
    bins_.rasterise(band, vertices_, of);
    clipped_bins_.rasterise(band, clipped_vertices_, of);
}

void BlockRasteriser::list_spans(Row& row, const std::uint8_t* state, const EdgePixels& edges,
                                 std::uint8_t* rgb) const {
    using block_vectors::mixed;
    row.mixed.clear();
    for (std::size_t i = 0; i < edges.count; ++i) {
        const std::int32_t x = edges.pixel[i];
        if (state[x] == mixed) {
            row.mixed.push_back(
                {{edges.sums[0][i], edges.sums[1][i], edges.sums[2][i]}, edges.kinds[i]});
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * static_cast<std::size_t>(x) + c] =
                root_of_mean(edges.sums[c][i], EdgePixels::samples);
    }
    list_unfinished(row, state);
}

void BlockRasteriser::list_unfinished(Row& row, const std::uint8_t* state) const {
    using block_vectors::surface_only;
    row.spans.clear();
    const std::uint8_t* end = state + tile_.width;
    for (const std::uint8_t* at = state; at != end;) {
        const std::uint8_t here = *at;
        const std::uint8_t* next =
            std::find_if(at, end, [here](std::uint8_t other) { return other != here; });
        if (here != surface_only)
            row.spans.push_back(
                {static_cast<int>(at - state), static_cast<int>(next - state), here});
        at = next;
    }
}

block_vectors::PixelRow BlockRasteriser::pixel_row(int row, int band, const Camera& camera,
                                                   const Scratch& scratch) const {
    const std::uint32_t* lower =
        scratch.samples.data() + static_cast<std::size_t>(factor * row) * scratch.stride;
    const int row_of_samples = first_sample_.y + factor * (band_rows * band + row);
    block_vectors::PixelRow of{lower, lower + scratch.stride, first_sample_.x, tile_.width, {},
                               {},    depths_of(camera)};
    for (int k = 0; k < factor; ++k) {
        const int at = row_of_samples + k;
        of.east[k] = rays_of(camera, 0, -0.5 * extent_.x, extent_.x, at, samples_);
        of.north[k] = rays_of(camera, 1, -0.5 * extent_.y, extent_.y, at, samples_);
    }
    return of;
}

block_vectors::Rays BlockRasteriser::height_rays(const Camera& camera, const glm::dvec2& heights,
                                                 int row_of_samples) const {
    return rays_of(camera, 2, heights.x, heights.y, row_of_samples, samples_);
}

void BlockRasteriser::for_bands(WorkerPool& pool,
                                const std::function<void(int band, Scratch& scratch)>& work) const {
    const int bands = (tile_.height + band_rows - 1) / band_rows;
    std::atomic<int> next = 0;
    pool.for_ranges(pool.size(), [&](int, int) {
        Scratch scratch(tile_.width);
        for (int band = next++; band < bands; band = next++) work(band, scratch);
    });
}

void BlockRasteriser::shade_band(int band, const Camera& camera, Scratch& scratch, Image& image) {
    const block_vectors::SurfaceTexture surface{colours_.texels.data(),
                                                colours_.width,
                                                colours_.height,
                                                grain_ > 0.0F ? packed_grain_.data() : nullptr,
                                                grain_texels_.x,
                                                grain_texels_.y,
                                                grain_};
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    for (int i = 0; i < rows; ++i) {
        const int upward = band_rows * band + i;
        const block_vectors::PixelRow of = pixel_row(i, band, camera, scratch);
        block_vectors::shade_row(of, surface,
                                 {scratch.planes.red.data(), scratch.planes.green.data(),
                                  scratch.planes.blue.data(), scratch.state.data()},
                                 scratch.edges);
        const int y = tile_.height - 1 - upward;
        const std::size_t first =
            static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(tile_.x);
        std::uint8_t* rgb = image.rgb.data() + 3 * first;
        write_row(scratch.planes, tile_.width, rgb);
        if (image.transparent())
            std::fill_n(image.alpha.data() + first, tile_.width, std::uint8_t{255});
        list_spans(rows_[static_cast<std::size_t>(y)], scratch.state.data(), scratch.edges, rgb);
    }
}

void BlockRasteriser::rasterise(const BlockMesh& shape, const Camera& camera, const Tile& tile,
                                WorkerPool& pool, Image& image) {
    tile_ = tile;
    extent_ = shape.extent;
    set_up_triangles(shape, camera, {image.width, image.height}, pool);
    rows_.resize(static_cast<std::size_t>(tile.height));
    for_bands(pool, [&](int band, Scratch& scratch) {
        rasterise_band(band, scratch);
        shade_band(band, camera, scratch, image);
    });
    find_sides();
}

bool needs_no_clipping(const Camera& camera, const glm::dvec3& lowest, const glm::dvec3& highest) {
    constexpr double far_outside = 100.0;  // half pictures: places in them are whole numbers
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) != 0 ? highest.x : lowest.x,
                               (corner & 2) != 0 ? highest.y : lowest.y,
                               (corner & 4) != 0 ? highest.z : lowest.z);
        const double depth = glm::dot(point - camera.eye, camera.forward);
        if (depth < camera.near_depth || depth > camera.far_depth) return false;
        const glm::dvec2 at = project(camera, point);
        if (std::abs(at.x) > far_outside || std::abs(at.y) > far_outside) return false;
    }
    return true;
}

}  // namespace fumon
