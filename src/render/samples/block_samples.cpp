#include "render/samples/block_samples.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/worker_pool.h"
#include "render/samples/cut_triangles.h"

namespace fumon {

namespace {

using block_vectors::Edges;
using block_vectors::Linear;
using triangle_vectors::Band;

/// A row of a matrix, for places 0 … 1 over the block.
Linear over_block(const glm::dmat4& matrix, int row, const glm::dvec2& extent) {
    const double east = matrix[0][row] * extent.x;
    const double north = matrix[1][row] * extent.y;
    return {east, north, matrix[2][row], matrix[3][row] - 0.5 * (east + north)};
}

Linear sum(const Linear& a, const Linear& b, double factor_of_both) {
    return {factor_of_both * (a.east + b.east), factor_of_both * (a.north + b.north),
            factor_of_both * (a.height + b.height), factor_of_both * (a.constant + b.constant)};
}

/// Where corners stand among so many samples.
block_vectors::Placed placed_by(const Camera& camera, const glm::dvec2& extent,
                                const glm::ivec2& samples) {
    const glm::dmat4 matrix = clip_matrix(camera);
    const Linear depth = over_block(matrix, 3, extent);
    constexpr double parts = 128.0;  // half of the 256 that a sample has
    block_vectors::Placed placed{sum(over_block(matrix, 0, extent), depth, parts * samples.x),
                                 sum(over_block(matrix, 1, extent), depth, parts * samples.y),
                                 {0.0, 0.0, 0.0, camera.near_depth},
                                 depth,
                                 camera.perspective ? camera.near_depth : 0.5};
    if (!camera.perspective) {
        const double range = camera.far_depth - camera.near_depth;
        const double east = -camera.forward.x * extent.x / range;
        const double north = -camera.forward.y * extent.y / range;
        const double from_eye = camera.far_depth + glm::dot(camera.forward, camera.eye);
        placed.nearness = {east, north, -camera.forward.z / range,
                           from_eye / range - 0.5 * (east + north)};
    }
    return placed;
}

/// How places along one axis, of which `first` is 0, follow from nearness in a row of samples.
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

BlockSamples::Room::Room(int pixels)
    : stride(static_cast<std::size_t>(factor * pixels) + Band::beyond),
      samples(stride * factor * band_rows + Band::beyond),
      planes(pixels),
      state(static_cast<std::size_t>(pixels) + Band::beyond) {
    edges.make_room(pixels);
    listed.make_room(pixels);
}

void BlockSamples::set_colours(glm::vec2 grain_texels, BlockColours& read) {
    grain_texels_ = grain_texels;
    if (grain_ > 0.0F && packed_grain_.empty()) packed_grain_ = block_vectors::packed_grain();
    std::swap(colours_, read);
}

void BlockSamples::place(const BlockShape& shape, const Camera& camera, const glm::ivec2& picture,
                         WorkerPool& pool) {
    samples_ = factor * picture;
    first_sample_ = factor * glm::ivec2(tile_.x, picture.y - tile_.y - tile_.height);
    const block_vectors::Placed placed = placed_by(camera, shape.extent, samples_);
    const std::size_t surface = shape.surface.heights.size();
    const std::size_t sides = shape.sides.heights.size();
    corners_.resize(surface + sides);
    block_vectors::place_corners(placed, shape.surface.places.data(), shape.surface.heights.data(),
                                 surface, corners_, 0);
    block_vectors::place_corners(placed, shape.sides.places.data(), shape.sides.heights.data(),
                                 sides, corners_, surface);
    std::vector<TrianglePart> parts{
        {shape.surface_triangles, 0, block_vectors::surface_kind, shape.both_faces}};
    for (std::size_t side = 0; side < shape.side_triangles.size(); ++side)
        parts.push_back({shape.side_triangles[side], surface,
                         static_cast<std::uint32_t>(first_side + side), shape.both_faces});
    bands_.sort(corners_, parts, first_sample_.y, factor * tile_.height, factor * band_rows, pool);
    cut_corners_.resize(0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        TrianglePart& part = parts[p];
        cut_[p].clear();
        const BlockShape::Corners& corners = p == 0 ? shape.surface : shape.sides;
        for (const std::uint32_t triangle : bands_.unplaced(p)) {
            std::array<DeepPlace, 3> places{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t corner = part.triangles[std::size_t{3} * triangle + k];
                const double east = corners.places[std::size_t{2} * corner];
                const double north = corners.places[std::size_t{2} * corner + 1];
                const double height = corners.heights[corner];
                const auto value = [&](const Linear& of) {
                    return of.east * east + of.north * north + of.height * height + of.constant;
                };
                places[k] = {value(placed.x), value(placed.y), value(placed.depth)};
            }
            add_cut(places, placed.least_depth, cut_corners_, cut_[p]);
        }
        part.triangles = cut_[p];
        part.first_corner = 0;
    }
    cut_bands_.sort(cut_corners_, std::move(parts), first_sample_.y, factor * tile_.height,
                    factor * band_rows, pool);
}

void BlockSamples::draw_band(int band, Room& room) const {
    const int first_row = first_sample_.y + factor * band_rows * band;
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    std::fill(room.samples.begin(), room.samples.end(), 0U);
    const Band of{room.samples.data(), room.stride,
                  first_sample_.x,     first_sample_.x + factor * tile_.width,
                  first_row,           first_row + factor * rows};
    bands_.draw(band, corners_, of);
    cut_bands_.draw(band, cut_corners_, of);
}

void BlockSamples::list_runs(Row& row, const std::uint8_t* state, const Edges& edges,
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
                root_of_mean(edges.sums[c][i], Edges::samples);
    }
    list_unfinished(row, state);
}

void BlockSamples::list_unfinished(Row& row, const std::uint8_t* state) const {
    using block_vectors::finished;
    row.runs.clear();
    const std::uint8_t* end = state + tile_.width;
    for (const std::uint8_t* at = state; at != end;) {
        const std::uint8_t here = *at;
        const std::uint8_t* next =
            std::find_if(at, end, [here](std::uint8_t other) { return other != here; });
        if (here != finished)
            row.runs.push_back(
                {static_cast<int>(at - state), static_cast<int>(next - state), here});
        at = next;
    }
}

block_vectors::PixelRow BlockSamples::pixel_row(int row, int band, const Camera& camera,
                                                const Room& room) const {
    const std::uint32_t* lower =
        room.samples.data() + static_cast<std::size_t>(factor * row) * room.stride;
    const int row_of_samples = first_sample_.y + factor * (band_rows * band + row);
    block_vectors::PixelRow of{lower, lower + room.stride, first_sample_.x, tile_.width, {},
                               {},    depths_of(camera)};
    for (int k = 0; k < factor; ++k) {
        const int at = row_of_samples + k;
        of.east[k] = rays_of(camera, 0, -0.5 * extent_.x, extent_.x, at, samples_);
        of.north[k] = rays_of(camera, 1, -0.5 * extent_.y, extent_.y, at, samples_);
    }
    return of;
}

block_vectors::Rays BlockSamples::height_rays(const Camera& camera, const glm::dvec2& heights,
                                              int row_of_samples) const {
    return rays_of(camera, 2, heights.x, heights.y, row_of_samples, samples_);
}

void BlockSamples::for_bands(WorkerPool& pool,
                             const std::function<void(int band, Room& room)>& work) const {
    const int bands = (tile_.height + band_rows - 1) / band_rows;
    std::atomic<int> next = 0;
    pool.for_ranges(pool.size(), [&](int, int) {
        Room room(tile_.width);
        for (int band = next++; band < bands; band = next++) work(band, room);
    });
}

void BlockSamples::colour_band(int band, const Camera& camera, Room& room, Image& image) {
    const block_vectors::Surface surface{colours_.texels.data(),
                                         colours_.width,
                                         colours_.height,
                                         grain_ > 0.0F ? packed_grain_.data() : nullptr,
                                         grain_texels_.x,
                                         grain_texels_.y,
                                         grain_};
    const int rows = std::min(band_rows, tile_.height - band_rows * band);
    for (int i = 0; i < rows; ++i) {
        const int upward = band_rows * band + i;
        const block_vectors::PixelRow of = pixel_row(i, band, camera, room);
        block_vectors::colour_row(of, surface,
                                  {room.planes.red.data(), room.planes.green.data(),
                                   room.planes.blue.data(), room.state.data()},
                                  room.edges);
        const int y = tile_.height - 1 - upward;
        const std::size_t first =
            static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(tile_.x);
        std::uint8_t* rgb = image.rgb.data() + 3 * first;
        put_row(room.planes, tile_.width, rgb);
        if (image.transparent())
            std::fill_n(image.alpha.data() + first, tile_.width, std::uint8_t{255});
        list_runs(rows_[static_cast<std::size_t>(y)], room.state.data(), room.edges, rgb);
    }
}

void BlockSamples::see(const BlockShape& shape, const Camera& camera, const Tile& tile,
                       WorkerPool& pool, Image& image) {
    tile_ = tile;
    extent_ = shape.extent;
    place(shape, camera, {image.width, image.height}, pool);
    rows_.resize(static_cast<std::size_t>(tile.height));
    for_bands(pool, [&](int band, Room& room) {
        draw_band(band, room);
        colour_band(band, camera, room, image);
    });
    find_sides();
}

bool lies_before(const Camera& camera, const glm::dvec3& lowest, const glm::dvec3& highest) {
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
