#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "base/snapshot_lookup.h"
#include "figure/canvas/furniture.h"
#include "figure/panels/ground_axes.h"
#include "figure/words/words.h"

namespace fumon {

/// A direction of the ground that an arrow shows.
struct GroundDirection {
    glm::dvec2 towards{1.0, 0.0};  ///< a unit vector, east and north
    std::string label;
};

/// Toward +x, east, or where the winds of a run move the sand on balance; nothing where they
/// cancel.
inline std::optional<GroundDirection> wind_direction(const Snapshot& snapshot) {
    const std::optional<HorizontalDirection> way = downwind(snapshot);
    if (!way) return std::nullopt;
    return GroundDirection{{way->x, way->y},
                           snapshot.winds.size() > 1 ? word("drift") : word("wind")};
}

/// Water flows down the slope, toward −y, south.
inline GroundDirection flow_direction() {
    return {{0.0, -1.0}, word("flow")};
}

/// What an arrow with its label takes; `length` font sizes where nothing shortens it.
FurnitureSize ground_arrow_size(const Canvas& canvas, const GroundDirection& direction,
                                const GroundAxes& axes, double length = 2.6);

/// Draws an arrow that lies on the ground as `axes` show it, and its label above it, or beside it
/// where it points up or down, into `box`, which has its size.
void draw_ground_arrow(Canvas& canvas, const GroundDirection& direction, const GroundAxes& axes,
                       const CanvasBox& box, const Ink& ink = {}, double length = 2.6);

/// One of a run's winds.
struct GroundWind {
    glm::dvec2 towards{1.0, 0.0};  ///< a unit vector, east and north
    double drift = 1.0;            ///< the sand that it moves, of what the strongest does
    bool blows = false;            ///< at the moment
};

/// The winds of a run that has several; the one that blows now is the nearest one to the number
/// `wind_from` of the snapshot.
std::vector<GroundWind> ground_winds(const Snapshot& snapshot);

/// What a rose of winds takes, at most: an arrow of each toward a middle, the longer the more sand
/// it moves.
FurnitureSize ground_winds_size(const Canvas& canvas, const std::vector<GroundWind>& winds,
                                const GroundAxes& axes);

/// Draws such a rose, whose arrows lie on the ground as `axes` show it, around the middle of `box`;
/// the wind that blows dark, the others faint.
void draw_ground_winds(Canvas& canvas, const std::vector<GroundWind>& winds, const GroundAxes& axes,
                       const CanvasBox& box);

/// What a compass takes: a needle to the north, seen as `axes` show the ground, and the letter N.
FurnitureSize compass_size(const Canvas& canvas, const GroundAxes& axes, double length = 2.4);

/// Draws a compass into `box`, which has its size.
void draw_compass(Canvas& canvas, const GroundAxes& axes, const CanvasBox& box, const Ink& ink = {},
                  double length = 2.4);

}  // namespace fumon
