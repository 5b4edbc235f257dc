#pragma once

#include <vector>

#include "base/grid.h"
#include "render/view/block.h"
#include "render/view/mask_outline.h"

namespace fumon {

/// A bed as it is shown: heights as z of the block, finer than the model's cells where these are
/// few.
struct DisplayBed {
    Field<float>
        z;        ///< block lengths; no-data cells next to others continue them, the rest lie low
    Mask nodata;  ///< what lies outside the outline; empty when nothing is left out
    std::vector<OutlineLoop> outline;  ///< of the cells with data, in cells of the snapshot
    int refinement = 1;                ///< cells of this bed along a cell of the snapshot
    float dx = 1.0F;                   ///< block lengths
    float dy = 1.0F;
};

/// How often each cell is divided: beds of fewer than `smooth_enough` cells along the longer side
/// are refined, so that a paper's 100 × 100 sites do not look faceted, but not beyond the pixels of
/// the picture's longer side.
int refinement_of(int nx, int ny, int picture_side, int smooth_enough = 400);

/// The display bed of a snapshot.
DisplayBed display_bed(const Snapshot& snapshot, const Block& block, int refinement);

}  // namespace fumon
