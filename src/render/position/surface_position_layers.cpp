#include "render/position/surface_position_layers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "base/truncation.h"
#include "base/worker_pool.h"
#include "render/view/bilinear_height.h"

namespace fumon {

namespace {

constexpr std::size_t first_normal = 1;  // of the layers
constexpr std::size_t first_position = 4;
constexpr std::size_t first_field = 7;

glm::dvec3 unfolded(double packed) {
    const double high = std::floor(packed / 4096.0);
    glm::dvec3 normal(high / 2047.0 - 1.0, (packed - 4096.0 * high) / 2047.0 - 1.0, 0.0);
    normal.z = 1.0 - std::abs(normal.x) - std::abs(normal.y);
    if (normal.z < 0.0) {
        const double x = normal.x;
        normal.x = std::copysign(1.0 - std::abs(normal.y), x);
        normal.y = std::copysign(1.0 - std::abs(x), normal.y);
    }
    return glm::normalize(normal);
}

double within_one(double share) {
    return share - std::floor(share);
}

}  // namespace

SurfacePositionLayers::SurfacePositionLayers(int width, int height, DrawnGround ground)
    : width_(width), height_(height), ground_(std::move(ground)) {
    const Snapshot& snapshot = ground_.snapshot;
    const bool metres = snapshot.scale.in_metres;
    const char* length = metres ? "m" : "sites";
    const auto add = [&](const std::string& name, const std::string& unit, bool half) {
        layers_.push_back({name, unit, half,
                           std::vector<float>(static_cast<std::size_t>(width) *
                                              static_cast<std::size_t>(height))});
    };
    add("Z", length, false);
    for (const char* axis : {"X", "Y", "Z"}) add(std::string("normal.") + axis, "1", true);
    for (const char* axis : {"X", "Y", "Z"}) add(std::string("position.") + axis, length, false);
    add("field.height", metres ? "m" : "model heights", false);
    fields_.push_back(&snapshot.bed);
    scales_.push_back(metres ? snapshot.scale.height_unit : 1.0);
    for (const SnapshotField& field : snapshot.fields) {
        add("field." + field.name, field.unit, false);
        fields_.push_back(&field.values);
        scales_.push_back(1.0);
    }
}

/// By differences over two cells of the drawn surface, between which they change linearly.
glm::dvec3 SurfacePositionLayers::surface_normal(const glm::dvec2& share) const {
    const Field<float>& z = ground_.surface;
    const auto number = [&](long long at, int count) {
        return static_cast<int>(ground_.endless ? ((at % count) + count) % count
                                                : std::clamp<long long>(at, 0, count - 1));
    };
    const auto height = [&](long long i, long long j) {
        return static_cast<double>(z(number(i, z.nx()), number(j, z.ny())));
    };
    const double column = share.x * z.nx() - 0.5;
    const double row = share.y * z.ny() - 0.5;
    const long long i = truncated(std::floor(column));
    const long long j = truncated(std::floor(row));
    const double s = column - static_cast<double>(i);
    const double t = row - static_cast<double>(j);
    const auto slope = [&](long long a, long long b) {
        const auto over = [&](long long from, long long to, int count, double cell) {
            const int cells = ground_.endless ? 2 : number(to, count) - number(from, count);
            return cells > 0 ? 1.0 / (cells * cell) : 0.0;
        };
        const double dx = over(a - 1, a + 1, z.nx(),
                               ground_.ground.width_x * ground_.ground.tiles.count() / z.nx());
        const double dy = over(b - 1, b + 1, z.ny(), ground_.ground.width_y / z.ny());
        return glm::dvec2((height(a + 1, b) - height(a - 1, b)) * dx,
                          (height(a, b + 1) - height(a, b - 1)) * dy);
    };
    const glm::dvec2 mean = (1.0 - t) * ((1.0 - s) * slope(i, j) + s * slope(i + 1, j)) +
                            t * ((1.0 - s) * slope(i, j + 1) + s * slope(i + 1, j + 1));
    return glm::normalize(glm::dvec3(-mean, 1.0));
}

glm::dvec3 SurfacePositionLayers::copy_normal(const glm::dvec2& position) const {
    const glm::dvec2 extent(ground_.ground.width_x, ground_.ground.width_y);
    const glm::dvec2 share = ground_.copies.bed_position_at(position) / extent + 0.5;
    const glm::dvec2 on_bed = share - glm::floor(share);
    const glm::dvec3 normal = surface_normal(on_bed);
    const auto z = static_cast<double>(bilinear_height(ground_.surface, on_bed, true));
    const glm::dvec2 slope =
        ground_.copies.slope(ground_.copies.at(position), -glm::dvec2(normal) / normal.z, z);
    return glm::normalize(glm::dvec3(-slope, 1.0));
}

SurfacePositionLayers::SurfacePoint SurfacePositionLayers::surface_point_at(
    int x, int y, const float* texel) const {
    const Camera& camera = ground_.camera;
    const Block& block = ground_.block;
    SurfacePoint seen;
    const glm::dvec3 point(texel[0], texel[1], texel[2]);
    if (texel[3] != 0.0F || point != glm::dvec3(0.0)) {
        seen.anything = true;
        seen.point = ground_.endless ? point + camera.eye : point;
        seen.bed = texel[3] >= 0.0F;
        if (!seen.bed) {
            seen.normal = unfolded(-static_cast<double>(texel[3]) - 1.0);
            return seen;
        }
        if (ground_.copies.varies_at(glm::dvec2(seen.point))) {
            seen.normal = copy_normal(glm::dvec2(seen.point));
            return seen;
        }
        const Block& ground = ground_.ground;
        seen.normal = surface_normal(ground.tiles.in_maps(
            {seen.point.x / ground.width_x + 0.5, seen.point.y / ground.width_y + 0.5}));
        return seen;
    }
    if (!ground_.plain) return seen;
    const double right = (2.0 * (x + 0.5) / width_ - 1.0) * camera.half.x;
    const double up = (1.0 - 2.0 * (y + 0.5) / height_) * camera.half.y;
    const glm::dvec3 aside = right * camera.right + up * camera.up;
    const glm::dvec3 view = camera.perspective ? camera.forward + aside : camera.forward;
    const glm::dvec3 from = camera.perspective ? camera.eye : camera.eye + aside;
    if (view.z > -1e-4 * glm::length(view)) return seen;
    seen.anything = true;
    seen.point = from + view * ((block.base - from.z) / view.z);
    seen.normal = {0.0, 0.0, 1.0};
    return seen;
}

/// Where the bed has ended; `east` and `north` are shares of its sides.
bool SurfacePositionLayers::beside_bed(double east, double north) const {
    if (east < 0.0 || east >= 1.0 || north < 0.0 || north >= 1.0) return true;
    const Mask& nodata = ground_.snapshot.nodata;
    return !nodata.empty() &&
           nodata(static_cast<int>(east * nodata.nx()), static_cast<int>(north * nodata.ny())) != 0;
}

void SurfacePositionLayers::put(std::size_t pixel, const SurfacePoint& seen) {
    const Block& block = ground_.block;
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const auto set = [&](std::size_t layer, double value) {
        layers_[layer].values[pixel] = static_cast<float>(value);
    };
    const double depth = glm::dot(seen.point - ground_.camera.eye, ground_.camera.forward);
    layers_[0].values[pixel] = seen.anything ? static_cast<float>(depth * block.side)
                                             : std::numeric_limits<float>::infinity();
    const glm::dvec3 position(seen.point.x + 0.5 * block.width_x,
                              seen.point.y + 0.5 * block.width_y, seen.point.z - block.z(0.0));
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        set(first_normal + k, seen.normal[axis]);
        if (seen.anything) {
            set(first_position + k, position[axis] * block.side);
        } else {
            layers_[first_position + k].values[pixel] = none;
        }
    }
    const auto cell = [](double share, int count) {
        return truncated_within(share * count, 0, count - 1);
    };
    for (std::size_t k = 0; k < fields_.size(); ++k) {
        float& value = layers_[first_field + k].values[pixel];
        value = none;
        if (!seen.bed) continue;
        const WarpedGround copy = ground_.copies.at(glm::dvec2(seen.point));
        double east = position.x / block.width_x + copy.offset.x;
        double north = position.y / block.width_y + copy.offset.y;
        const bool plain = ground_.ground.tiles.plain;
        if (ground_.endless && !plain) {
            east = within_one(east);
            north = within_one(north);
        }
        if (plain && beside_bed(east, north)) continue;
        const Grid& field = *fields_[k];
        value =
            static_cast<float>(scales_[k] * field(cell(east, field.nx()), cell(north, field.ny())));
    }
}

void SurfacePositionLayers::add(const Tile& tile, const std::vector<float>& seen,
                                WorkerPool& pool) {
    pool.for_ranges(tile.height, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            const int y = tile.y + row;
            const float* texel = seen.data() + 4 * static_cast<std::size_t>(tile.width) *
                                                   static_cast<std::size_t>(tile.height - 1 - row);
            for (int column = 0; column < tile.width; ++column, texel += 4) {
                const int x = tile.x + column;
                const std::size_t pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x);
                put(pixel, surface_point_at(x, y, texel));
            }
        }
    });
}

void set_matrices(LayeredImage& image, const Block& block, const Camera& camera) {
    // Rows times matrix, of points in the layers' lengths.
    const glm::dvec3 origin(0.5 * block.width_x, 0.5 * block.width_y, -block.z(0.0));
    const auto fill = [&](std::array<float, 16>& to, const glm::dmat4& from_block) {
        const auto number = [&to](int row, int column) -> float& {
            const int at = 4 * row + column;
            return to.at(static_cast<std::size_t>(at));
        };
        for (int column = 0; column < 4; ++column) {
            double shift = from_block[3][column];
            for (int row = 0; row < 3; ++row) {
                const double factor = from_block[row][column];
                number(row, column) = static_cast<float>(factor / block.side);
                shift -= factor * origin[row];
            }
            number(3, column) = static_cast<float>(shift);
        }
    };
    glm::dmat4 to_camera(1.0);
    for (int row = 0; row < 3; ++row) {
        to_camera[row] = glm::dvec4(camera.right[row], camera.up[row], camera.forward[row], 0.0);
    }
    for (int axis = 0; axis < 3; ++axis) {
        to_camera[3][axis] =
            -(camera.eye.x * to_camera[0][axis] + camera.eye.y * to_camera[1][axis] +
              camera.eye.z * to_camera[2][axis]);
    }
    glm::dmat4 metric = to_camera;  // in lengths, not sides
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 4; ++row) metric[row][column] *= block.side;
    }
    fill(image.world_to_camera, metric);
    const glm::dmat4 clip = clip_matrix(camera);
    glm::dmat4 picture = clip;
    for (int row = 0; row < 4; ++row) {
        picture[row][0] = 0.5 * (clip[row][0] + clip[row][3]);
        picture[row][1] = 0.5 * (clip[row][3] - clip[row][1]);
    }
    fill(image.world_to_picture, picture);
}

}  // namespace fumon
