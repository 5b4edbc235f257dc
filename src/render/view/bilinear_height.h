#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/grid.h"
#include "base/truncation.h"

namespace fumon {

/// The height of a drawn bed at a point, as shares of its sides from the south-west corner; linear
/// between cells. `repeats`: beyond its edges it goes on with its other side.
template <class Number>
Number bilinear_height(const Field<Number>& z, const glm::dvec2& share, bool repeats) {
    struct Split {
        int low;
        int high;
        Number weight;
    };
    const auto split = [&](double at, int count) {
        const double cell = at * count - 0.5;
        const double low = std::floor(cell);
        const auto number = [&](double value) {
            if (!repeats) return truncated_within(value, 0, count - 1);
            return static_cast<int>((truncated(value) % count + count) % count);
        };
        return Split{number(low), number(low + 1.0), static_cast<Number>(cell - low)};
    };
    const Split x = split(share.x, z.nx());
    const Split y = split(share.y, z.ny());
    return std::lerp(std::lerp(z(x.low, y.low), z(x.high, y.low), x.weight),
                     std::lerp(z(x.low, y.high), z(x.high, y.high), x.weight), y.weight);
}

/// Column and row of the cell with data that is nearest to a cell: itself where it has some, or
/// where none has.
inline std::array<int, 2> known_cell(const Mask& nodata, int column, int row) {
    if (nodata.empty() || nodata(column, row) == 0) return {column, row};
    std::array<int, 2> nearest{column, row};
    long long least = std::numeric_limits<long long>::max();
    for (int y = 0; y < nodata.ny(); ++y) {
        for (int x = 0; x < nodata.nx(); ++x) {
            if (nodata(x, y) != 0) continue;
            const long long across = x - column;
            const long long up = y - row;
            if (across * across + up * up >= least) continue;
            least = across * across + up * up;
            nearest = {x, y};
        }
    }
    return nearest;
}

}  // namespace fumon
