#include "render/view/tile_warp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/compensated_sum.h"
#include "render/view/drawn_origin.h"
#include "render/view/framing.h"
#include "render/view/surrounding_plain.h"
#include "render/view/tile_warp_vectors.h"
#include "render/view/tile_warp_waves.h"

namespace fumon {

namespace {

/// Length of a bed's waves in its sides: 2π times the height over the slope, both as root mean
/// squares; of one whose landforms are still to grow what they usually come to.
double landform_share(const Snapshot& bed) {
    const HeightStatistics heights = height_statistics(bed.bed, bed.nodata);
    if (heights.smoothness < 0.5) return 0.15;
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    CompensatedSum squares;  // the same wherever a bed begins
    CompensatedSum slopes;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double z = bed.bed(x, y);
            const double east = (bed.bed((x + 1) % nx, y) - z) * nx;
            const double north = (bed.bed(x, (y + 1) % ny) - z) * ny;
            squares.add((z - heights.mean) * (z - heights.mean));
            slopes.add(0.5 * (east * east + north * north));
        }
    }
    if (slopes.value() <= 0.0) return 0.15;
    return 2.0 * std::numbers::pi * std::sqrt(squares.value() / slopes.value());
}

double strength_of(const Snapshot& bed) {
    constexpr double many = 0.12;  // share of the sides that a landform has
    constexpr double few = 0.25;
    constexpr double least = 0.6;
    const double share = std::clamp((landform_share(bed) - many) / (few - many), 0.0, 1.0);
    return 0.01 * std::round(100.0 * std::lerp(least, 1.0, share));
}

}  // namespace

TileWarp::TileWarp(const Camera& first, const Block& block, const Snapshot& bed)
    : strength_(strength_of(bed)),
      extent_(block.width_x, block.width_y),
      cells_(bed.bed.nx(), bed.bed.ny()),
      mean_(block.surface) {
    glm::dvec2 middle(block.look_at.value_or(glm::dvec3(0.0)));
    if (block.eye) {
        // What it looks at is as it is, and where it stands, if that is no farther than a period.
        constexpr double most = 0.5 * tile_warp::unwarped_radius_periods;
        const glm::dvec2 eye(first.eye);
        const glm::dvec2 seen(first.eye + first.focus * first.forward);
        const double apart = glm::length((eye - seen) / extent_);
        middle = seen + std::min(0.5, most / std::max(apart, 1e-9)) * (eye - seen);
    }
    // Of a whole cell, as the drawn bed's origin is.
    middle_ = glm::floor(middle / extent_ * cells_ + cell_boundary_offset) / cells_;
}

bool TileWarp::varies_at(const glm::dvec2& position) const {
    return varied() &&
           glm::distance(position / extent_, middle_) > tile_warp::unwarped_radius_periods;
}

WarpedGround TileWarp::at(const glm::dvec2& position) const {
    if (!varies_at(position)) return {};
    return tile_warp::warp_at(position / extent_ - middle_, strength_);
}

glm::dvec2 TileWarp::slope(const WarpedGround& copy, const glm::dvec2& on_bed, double z) const {
    const glm::dvec2 a_period = copy.height * (on_bed * extent_ * copy.jacobian);
    return (a_period + (z - mean_) * copy.height_gradient) / extent_;
}

glm::dvec2 TileWarp::from_middle(const glm::dvec2& share, const glm::dvec2& within) const {
    return glm::round((share - middle_) * cells_) / cells_ + within;
}

glm::dvec2 TileWarp::bed_position_at(const glm::dvec2& position) const {
    return position + at(position).offset * extent_;
}

glm::dvec2 TileWarp::ground_position_of(const glm::dvec2& shown) const {
    constexpr int most_steps = 20;
    constexpr double near = 1e-7;  // periods
    glm::dvec2 position = shown;
    if (!varied()) return position;
    for (int i = 0; i < most_steps; ++i) {  // Newton's method
        const WarpedGround copy = at(position);
        const glm::dvec2 off = shown / extent_ - position / extent_ - copy.offset;
        position += glm::inverse(copy.jacobian) * off * extent_;
        if (glm::length(off) < near) break;
    }
    return position;
}

bool tiles_are_warped(const View& view, bool repeats) {
    return view.look.ground == Ground::endless && repeats &&
           view.look.far_copies == FarGround::varied;
}

TileWarp tile_warp_of(const View& view, const Block& block, const Snapshot& first) {
    if (!tiles_are_warped(view, !is_bounded(first))) return {};
    return {camera_at_step(view, block, 0, 1), block, first};
}

}  // namespace fumon
