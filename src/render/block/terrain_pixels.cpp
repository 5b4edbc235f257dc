#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "gl/functions.h"
#include "render/block/terrain_layer.h"

namespace fumon {

namespace {

constexpr double around_box = 0.01;  // block lengths
constexpr std::size_t rim = 1;       // faces before those of the four sides

static_assert(std::is_trivially_copyable_v<MeshPosition> &&
              sizeof(MeshPosition) == 2 * sizeof(float));

constexpr int sides = 4;  // west, east, south, north
constexpr int strips_per_side = 32;
constexpr int vertices_per_strip = 6;
constexpr float around_strip = 0.01F;  // block lengths: some pixels
constexpr float over_next = 0.0005F;   // strips of unlike heights overlap, lest there be cracks
constexpr int ground_texels = 1024;    // along a side
constexpr int side_ground_unit = 1;
const gl::TextureLayout ground_layout{GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
// Of the ground, and of the surface of water over it.
const gl::TextureLayout both_layout{GL_RG32F, GL_RG, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};

/// A corner as block/side.vert.glsl takes it.
struct StripCorner {
    MeshPosition at;
    MeshPosition normal;
    float height;
};

/// Heights along a side of a lattice, from its western or southern end on.
struct Border {
    std::vector<float> positions;  // 0 … 1
    std::vector<float> heights;

    /// In between linear.
    [[nodiscard]] float height_at(float position) const {
        const auto after = std::ranges::upper_bound(positions, position);
        const auto next = std::clamp<std::ptrdiff_t>(
            after - positions.begin(), 1, static_cast<std::ptrdiff_t>(positions.size()) - 1);
        const auto k = static_cast<std::size_t>(next);
        const float share = (position - positions[k - 1]) / (positions[k] - positions[k - 1]);
        return heights[k - 1] + share * (heights[k] - heights[k - 1]);
    }
    /// The highest between two places.
    [[nodiscard]] float highest(float from, float to) const {
        float result = std::max(height_at(from), height_at(to));
        for (std::size_t k = 0; k < positions.size(); ++k)
            if (positions[k] >= from && positions[k] <= to) result = std::max(result, heights[k]);
        return result;
    }
    [[nodiscard]] float lowest() const { return *std::ranges::min_element(heights); }
};

bool runs_north(int side) {
    return side < 2;
}

bool at_far_end(int side) {
    return side % 2 == 1;
}

Border border_of(const TerrainLattice& lattice, const std::vector<float>& heights, int side) {
    const int count = runs_north(side) ? lattice.ny : lattice.nx;
    const int across = at_far_end(side) ? (runs_north(side) ? lattice.nx : lattice.ny) - 1 : 0;
    Border border;
    for (int k = 0; k < count; ++k) {
        const int at = runs_north(side) ? k * lattice.nx + across : across * lattice.nx + k;
        const MeshPosition position = lattice.positions[static_cast<std::size_t>(at)];
        border.positions.push_back(runs_north(side) ? position.north : position.east);
        border.heights.push_back(heights[static_cast<std::size_t>(at)]);
    }
    return border;
}

void add_strips(const Border& border, int side, float base, float width,
                std::vector<StripCorner>& corners) {
    const float across = at_far_end(side) ? 1.0F : 0.0F;
    const float outward = at_far_end(side) ? 1.0F : -1.0F;
    const MeshPosition normal =
        runs_north(side) ? MeshPosition{outward, 0.0F} : MeshPosition{0.0F, outward};
    const float low = std::min(base, border.lowest()) - around_strip;
    for (int i = 0; i < strips_per_side; ++i) {
        float from = static_cast<float>(i) / strips_per_side;
        float to = static_cast<float>(i + 1) / strips_per_side;
        const float high = border.highest(from, to) + around_strip;
        from -= (i == 0 ? around_strip : over_next) / width;
        to += (i == strips_per_side - 1 ? around_strip : over_next) / width;
        const auto corner = [&](float along, float height) {
            const MeshPosition at =
                runs_north(side) ? MeshPosition{across, along} : MeshPosition{along, across};
            return StripCorner{at, normal, height};
        };
        const std::array<StripCorner, 4> of{corner(from, low), corner(to, low), corner(to, high),
                                            corner(from, high)};
        for (const std::size_t k : {0U, 1U, 2U, 0U, 2U, 3U}) corners.push_back(of[k]);
    }
}

void corner_attribute(GLuint position, GLint count, std::size_t offset) {
    gl::functions().VertexAttribPointer(position, count, GL_FLOAT, GL_FALSE, sizeof(StripCorner),
                                        reinterpret_cast<const void*>(offset));
    gl::functions().EnableVertexAttribArray(position);
}

}  // namespace

BlockMesh TerrainLayer::shape(const Camera& camera) const {
    BlockMesh shape;
    shape.surface = {{&lattice_.positions.front().east, 2 * lattice_.positions.size()}, surface_};
    shape.sides = {side_positions_, side_heights_};
    shape.surface_triangles = mesh_.triangles;
    if (view_.look.block_sides) {
        for (std::size_t side = 0; side < shape.side_triangles.size(); ++side)
            shape.side_triangles[side] = faces_[rim + side].drawn;
    }
    shape.extent = {block_.width_x, block_.width_y};
    shape.double_sided = !backs_are_hidden(camera);
    return shape;
}

bool TerrainLayer::needs_no_clipping(const Camera& camera) const {
    const glm::dvec2 half = 0.5 * glm::dvec2(block_.width_x, block_.width_y) + around_box;
    double lowest = std::min(static_cast<double>(height_range_.x), block_.base);
    double highest = static_cast<double>(height_range_.y);
    for (const float height : surface_) {
        lowest = std::min(lowest, static_cast<double>(height));
        highest = std::max(highest, static_cast<double>(height));
    }
    return fumon::needs_no_clipping(camera, glm::dvec3(-half, lowest - around_box),
                                    glm::dvec3(half, highest + around_box));
}

const TerrainLayer::Strips& TerrainLayer::strips() {
    const gl::Functions& gl = gl::functions();
    if (!strips_) {
        strips_.emplace(
            Strips{{"block/side.vert.glsl",
                    by_pixels_ ? "block/side_strip_water.frag.glsl" : "block/side_strip.frag.glsl",
                    {"east_north", "normal", "heights"},
                    fixed_},
                   {},
                   gl::DynamicBuffer(GL_ARRAY_BUFFER),
                   gl::Texture2D(ground_texels, sides, by_pixels_ ? both_layout : ground_layout)});
        gl.BindVertexArray(strips_->array.name());
        strips_->corners.bind();
        corner_attribute(0, 2, offsetof(StripCorner, at));
        corner_attribute(1, 2, offsetof(StripCorner, normal));
        corner_attribute(2, 1, offsetof(StripCorner, height));
        gl.BindVertexArray(0);
    }
    if (strips_made_) return *strips_;
    strips_made_ = true;
    std::vector<StripCorner> corners;
    std::vector<float> ground;
    for (int side = 0; side < sides; ++side) {
        const Border border = border_of(lattice_, surface_, side);
        const Border bed = border_of(lattice_, ground_, side);
        add_strips(border, side, static_cast<float>(block_.base),
                   static_cast<float>(runs_north(side) ? block_.width_y : block_.width_x), corners);
        for (int i = 0; i < ground_texels; ++i) {
            const float position = (static_cast<float>(i) + 0.5F) / ground_texels;
            const auto share = [&](const Border& of) {
                return (of.height_at(position) - height_range_.x) /
                       (height_range_.y - height_range_.x);
            };
            ground.push_back(share(bed));
            if (by_pixels_) ground.push_back(share(border));
        }
    }
    strips_->corners.fill(corners);
    strips_->ground.bind(side_ground_unit);
    strips_->ground.upload(ground.data());
    return *strips_;
}

void TerrainLayer::shade_side(int side, const Light& light, const Camera& camera,
                              const TileSamples& tile) {
    const Strips& of_sides = strips();
    const gl::Functions& gl = gl::functions();
    gl.Disable(GL_DEPTH_TEST);
    set_transform(of_sides.program, camera, tile);
    set_sides(of_sides.program, light, camera);
    of_sides.ground.bind(side_ground_unit);
    of_sides.program.set("ground_map", side_ground_unit);
    of_sides.program.set("ground_row", (static_cast<float>(side) + 0.5F) / sides);
    gl.BindVertexArray(of_sides.array.name());
    constexpr int corners = strips_per_side * vertices_per_strip;
    gl.DrawArrays(GL_TRIANGLES, side * corners, corners);
    gl.BindVertexArray(0);
}

}  // namespace fumon
