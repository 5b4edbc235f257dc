#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// A line of equal value over a grid.
struct ContourLine {
    double level = 0.0;
    /// In cells: (0, 0) is the middle of the first cell, x eastward, y northward. Higher ground
    /// lies to the left. A closed line ends where it begins.
    std::vector<glm::dvec2> points;

    [[nodiscard]] bool closed() const {
        return points.size() > 2 && points.front() == points.back();
    }
};

/// The lines along which a field, linear between neighbouring cells, has a value (marching squares;
/// where a square's two diagonals cross it, the mean of its corners says which of them it joins).
/// Values that equal the level count as higher. Nothing crosses a square with a corner outside the
/// domain (`nodata` 1; empty: none) or that is not finite. In the order in which a scan from the
/// south-west meets them.
std::vector<ContourLine> contour_lines(const Grid& values, const Mask& nodata, double level);

/// A round distance between lines, 1, 2 or 5 times a power of ten, that draws at most `most` of
/// them between two values; 0 where they are equal or not finite.
double contour_interval(double low, double high, int most = 16);

}  // namespace fumon
