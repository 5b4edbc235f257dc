#pragma once

#include "render/life/body_shapes.h"
#include "render/life/person_figure.h"

namespace fumon {

/// How the upper body stands over the legs.
struct Carriage {
    double sway = 0.0;   ///< metres of the hips aside
    double drop = 0.0;   ///< of the shoulders, a share of the way aside
    double twist = 0.0;  ///< radians anticlockwise, of the shoulders
    double lean = 0.0;   ///< metres of the shoulders forward
};

/// Neck and head of a person of 1.75 m, with hair and what covers it.
void add_head(BodyMesh& mesh, const PersonFigure& figure, const Carriage& carriage);

}  // namespace fumon
