#include "render/view/far_copies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/compensated_sum.h"
#include "render/view/drawn_origin.h"
#include "render/view/far_copies_vectors.h"
#include "render/view/far_copies_waves.h"
#include "render/view/framing.h"
#include "render/view/plain_around.h"

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

FarCopies::FarCopies(const Camera& first, const Block& block, const Snapshot& bed)
    : strength_(strength_of(bed)),
      extent_(block.width_x, block.width_y),
      cells_(bed.bed.nx(), bed.bed.ny()),
      mean_(block.surface) {
    glm::dvec2 middle(block.look_at.value_or(glm::dvec3(0.0)));
    if (block.eye) {
        // What it looks at is as it is, and where it stands, if that is no farther than a period.
        constexpr double most = 0.5 * far_copies::as_it_is;
        const glm::dvec2 eye(first.eye);
        const glm::dvec2 seen(first.eye + first.focus * first.forward);
        const double apart = glm::length((eye - seen) / extent_);
        middle = seen + std::min(0.5, most / std::max(apart, 1e-9)) * (eye - seen);
    }
    // Of a whole cell, as the drawn bed's origin is.
    middle_ = glm::floor(middle / extent_ * cells_ + begin_of_cells) / cells_;
}

bool FarCopies::varies_at(const glm::dvec2& place) const {
    return varied() && glm::distance(place / extent_, middle_) > far_copies::as_it_is;
}

GroundCopy FarCopies::at(const glm::dvec2& place) const {
    if (!varies_at(place)) return {};
    return far_copies::copy_at(place / extent_ - middle_, strength_);
}

glm::dvec2 FarCopies::slope(const GroundCopy& copy, const glm::dvec2& on_bed, double z) const {
    const glm::dvec2 a_period = copy.height * (on_bed * extent_ * copy.way);
    return (a_period + (z - mean_) * copy.growth) / extent_;
}

glm::dvec2 FarCopies::from_middle(const glm::dvec2& share, const glm::dvec2& within) const {
    return glm::round((share - middle_) * cells_) / cells_ + within;
}

glm::dvec2 FarCopies::shown_at(const glm::dvec2& place) const {
    return place + at(place).aside * extent_;
}

glm::dvec2 FarCopies::place_of(const glm::dvec2& shown) const {
    constexpr int most_steps = 20;
    constexpr double near = 1e-7;  // periods
    glm::dvec2 place = shown;
    if (!varied()) return place;
    for (int i = 0; i < most_steps; ++i) {  // Newton's method
        const GroundCopy copy = at(place);
        const glm::dvec2 off = shown / extent_ - place / extent_ - copy.aside;
        place += glm::inverse(copy.way) * off * extent_;
        if (glm::length(off) < near) break;
    }
    return place;
}

bool far_copies_vary(const View& view, bool repeats) {
    return view.look.ground == Ground::endless && repeats &&
           view.look.far_copies == FarGround::varied;
}

FarCopies far_copies_of(const View& view, const Block& block, const Snapshot& first) {
    if (!far_copies_vary(view, !ends_somewhere(first))) return {};
    return {camera_at_step(view, block, 0, 1), block, first};
}

}  // namespace fumon
