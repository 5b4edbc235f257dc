#pragma once

#include <algorithm>

#include "base/grid.h"

namespace fumon {

/// The field with x and y exchanged, tile by tile so that both sides stay in the cache.
template <class Number>
Field<Number> transposed(const Field<Number>& field) {
    constexpr int tile = 32;
    Field<Number> result(field.ny(), field.nx());
    for (int y0 = 0; y0 < field.ny(); y0 += tile) {
        for (int x0 = 0; x0 < field.nx(); x0 += tile) {
            const int y1 = std::min(y0 + tile, field.ny());
            const int x1 = std::min(x0 + tile, field.nx());
            for (int x = x0; x < x1; ++x)
                for (int y = y0; y < y1; ++y) result(y, x) = field(x, y);
        }
    }
    return result;
}

}  // namespace fumon
