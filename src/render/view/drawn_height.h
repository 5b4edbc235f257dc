#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/grid.h"

namespace fumon {

/// The height of a drawn bed at a place, as shares of its sides from the south-west corner; linear
/// between cells. `repeats`: beyond its edges it goes on with its other side.
template <class Number>
Number drawn_height(const Field<Number>& z, const glm::dvec2& share, bool repeats) {
    struct Split {
        int low;
        int high;
        Number weight;
    };
    const auto split = [&](double at, int count) {
        const double cell = at * count - 0.5;
        const double low = std::floor(cell);
        const auto number = [&](double value) {
            const int whole = static_cast<int>(value);
            return repeats ? (whole % count + count) % count : std::clamp(whole, 0, count - 1);
        };
        return Split{number(low), number(low + 1.0), static_cast<Number>(cell - low)};
    };
    const Split x = split(share.x, z.nx());
    const Split y = split(share.y, z.ny());
    return std::lerp(std::lerp(z(x.low, y.low), z(x.high, y.low), x.weight),
                     std::lerp(z(x.low, y.high), z(x.high, y.high), x.weight), y.weight);
}

}  // namespace fumon
