#include "render/view/display_bed.h"

#include <algorithm>

#include "numerics/resampling.h"

namespace fumon {

int refinement_of(int nx, int ny, int picture_side, int smooth_enough) {
    const int longer = std::max(nx, ny);
    const int wanted = std::min(smooth_enough, picture_side);
    return std::clamp((wanted + longer - 1) / longer, 1, 32);
}

DisplayBed display_bed(const Snapshot& snapshot, const Block& block, int refinement) {
    const Grid& bed = snapshot.bed;
    Field<float> z(bed.nx(), bed.ny());
    std::transform(bed.values().begin(), bed.values().end(), z.values().begin(),
                   [&](double height) { return static_cast<float>(block.z(height)); });
    DisplayBed shown;
    shown.refinement = refinement;
    if (!snapshot.nodata.empty()) {
        extrapolate_outward(z, snapshot.nodata, static_cast<float>(block.base));
        shown.outline = mask_outline(snapshot.nodata);
        shown.nodata = outside_of(shown.outline, bed.nx(), bed.ny(), refinement);
    }
    shown.z = refined(z, refinement);
    shown.dx = static_cast<float>(block.width_x * block.tiles.count() / shown.z.nx());
    shown.dy = static_cast<float>(block.width_y / shown.z.ny());
    return shown;
}

}  // namespace fumon
