#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/snapshot.h"
#include "render/view/ground_tiles.h"
#include "scene/scene.h"

namespace fumon {

/// The block of terrain in front of the camera, fixed by the run's first snapshot. Lengths are in
/// units of the block's longer side; the origin lies under its centre, x points east, y north, z
/// up. A cell covers dx × dy, so a bed of nx × ny cells measures nx·dx by ny·dy.
struct Block {
    double side = 1.0;          ///< the longer side, in the snapshot's lengths (metres or sites)
    double kilometres = 1.0;    ///< the same; 1 without metres
    double width_x = 1.0;       ///< extent eastward, in sides
    double width_y = 1.0;       ///< extent northward
    double exaggeration = 1.0;  ///< vertical
    double reference = 0.0;     ///< the model height at z = 0
    double height_scale = 1.0;  ///< z of one model height
    double base = 0.0;          ///< z of its underside
    double surface = 0.0;       ///< z of the first bed's mean
    double top = 0.0;           ///< z up to which it is framed: the first bed and room to grow
    /// Points whose convex hull is the domain's outline: its corners, or, where cells lie outside,
    /// both ends of every row.
    std::vector<glm::dvec2> outline;
    std::optional<glm::dvec3> eye;      ///< where the camera stands, if it stands at a point
    double eye_above = 0.0;             ///< the ground there, at least
    std::optional<glm::dvec3> look_at;  ///< what it looks at, if that is a point
    double rock = 0.0;                  ///< 0 sand … 1 mountains, for the natural colouring
    bool goes_on = false;               ///< invented land lies around it
    GroundTiles tiles;                  ///< of endless ground, whose block is one of them wide

    [[nodiscard]] double z(double height) const { return (height - reference) * height_scale; }
};

/// How a bed's heights are spread, no-data cells left out.
struct HeightStatistics {
    double low = 0.0;
    double high = 0.0;
    double mean = 0.0;
    /// Correlation of neighbours along x, 0 for noise, near 1 for terrain; 0 for a flat bed.
    double smoothness = 0.0;
};

HeightStatistics height_statistics(const Grid& bed, const Mask& nodata);

/// The vertical exaggeration that shows the relief, from the first snapshot alone. Real terrain
/// (heights in metres, neighbouring cells alike: correlation ≥ 0.5) gets the smallest of 1, 1.5, 2,
/// 3, 5, 10, 15, 20, 30, 50, 100 that makes its relief at least 12 % of the longer side; a noise or
/// flat bed, whose landforms are still to grow, and a bed without metres get 1. Under water the
/// relief counts as at least ten depths (their 99th percentile), which the water may carve, and a
/// noise or flat bed too gets the number that makes it 4 % of the longer side. Under a section it
/// is a smaller one of these numbers, if need be, that keeps the air below 35 % of that side.
double relief_exaggeration(const Snapshot& first);

/// The same, but of real terrain (without a section) at most the largest of these numbers that
/// leaves 99 % of its cells below 45°, so that slip faces and cliffs do not become spires; 1 where
/// they are steeper as they are.
double automatic_exaggeration(const Snapshot& first);

/// The vertical exaggeration by which the relief of a snapshot reads in a figure: the smallest
/// round number that makes its relief at least 12 % of the longer side, but no more than the
/// largest that leaves 99 % of its cells below 45°. At least 1 in metres; heights without a unit,
/// of which 90 % of the cells count, may be flattened to a tenth. Over water and under a section as
/// automatic_exaggeration().
double figure_exaggeration(const Snapshot& snapshot);

/// Frames the first snapshot. `room` says how many model heights stay free above it. "auto": up to
/// where the model expects its landforms to grow, if it does; else a noise or flat bed gets room
/// for landforms 5 % of the longer side high and keeps its underside below model height −0.1, to
/// which the sand models dip; real terrain gets 1 %. Under water the bed has
/// room below it for half of what its relief lacks of ten depths, at most 5 % of the longer side.
/// `footing`: how many model heights the underside lies below the lowest point, where that is a
/// number.
Block frame_block(const Snapshot& first, double exaggeration,
                  const WordOrReal& room = {"auto", 0.0},
                  const WordOrReal& footing = {"auto", 0.0});

}  // namespace fumon
