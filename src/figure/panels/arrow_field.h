#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "figure/plot/axes.h"

namespace fumon {

/// Velocities over the plane of a pair of axes.
struct ArrowField {
    /// At a pair of the axes' values, along both axes; none where there is nothing to show.
    std::function<std::optional<glm::dvec2>(double x, double y)> velocity;
    double fastest = 0.0;  ///< the speed whose arrow is the longest; none are drawn for 0
    std::string unit = "m/s";
    double apart_x = 1.8;  ///< of neighbouring arrows, font sizes
    double apart_y = 0.8;
};

/// Draws arrows at evenly spaced places: as long as the speed, the longest nearly as far as they
/// are apart, and pointing where the flow goes in the picture, whose axes may differ in scale.
void draw_arrow_field(Canvas& canvas, const Axes& axes, const ArrowField& field);

/// Draws an arrow of a round speed with that speed above the frame's right end, within
/// reference_arrow_room_em font sizes of it. Returns the width that it takes, units.
double draw_reference_arrow(Canvas& canvas, const Axes& axes, const ArrowField& field);
constexpr double reference_arrow_room_em = 1.5;

}  // namespace fumon
