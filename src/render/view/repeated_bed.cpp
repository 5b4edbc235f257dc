#include "render/view/repeated_bed.h"

#include <algorithm>
#include <cmath>

namespace fumon {

DisplayBed display_bed_with_margin(const Snapshot& snapshot, const Block& block, int refinement,
                                   int margin) {
    Snapshot wide;
    wide.bed = with_margin(snapshot.bed, margin);
    Block around = block;
    around.width_x *= static_cast<double>(wide.bed.nx()) / snapshot.bed.nx();
    around.width_y *= static_cast<double>(wide.bed.ny()) / snapshot.bed.ny();
    return display_bed(wide, around, refinement);
}

int shading_margin(const Snapshot& snapshot, const Block& block, double lowest_ray) {
    const auto [low, high] = std::ranges::minmax(snapshot.bed.values());
    const double cell =
        std::min(block.width_x / snapshot.bed.nx(), block.width_y / snapshot.bed.ny());
    const double longest_shadow = (high - low) * block.height_scale / std::max(lowest_ray, 1e-3);
    const int shorter = std::min(snapshot.bed.nx(), snapshot.bed.ny());
    const double cells = std::clamp(longest_shadow / cell, shorter / 8.0, 1.0 * shorter);
    return static_cast<int>(std::ceil(cells)) + 2;
}

}  // namespace fumon
