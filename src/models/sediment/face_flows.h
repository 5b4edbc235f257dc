#pragma once

#include <array>

#include "base/grid.h"

namespace fumon {

/// What passed the faces of the cells in the two stages of a sub-step, and the depth between them:
/// all that a quantity needs which the water carries, to be carried with it exactly.
struct FaceFlows {
    struct Stage {
        Grid east;   ///< (nx + 1) × ny: eastward through the face west of cell x, m²/s
        Grid north;  ///< nx × (ny + 1): northward through the face south of cell y, m²/s
    };
    std::array<Stage, 2> stages;
    const Grid* between = nullptr;  ///< m, after the first

    FaceFlows() = default;
    FaceFlows(int nx, int ny)
        : stages{Stage{Grid(nx + 1, ny), Grid(nx, ny + 1)},
                 Stage{Grid(nx + 1, ny), Grid(nx, ny + 1)}} {}
};

}  // namespace fumon
