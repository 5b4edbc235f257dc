#pragma once

#include "base/grid.h"

namespace fumon {

/// A periodic field with `margin` of its own cells again on each side.
template <class Number>
Field<Number> with_margin(const Field<Number>& field, int margin) {
    const int nx = field.nx();
    const int ny = field.ny();
    Field<Number> wide(nx + 2 * margin, ny + 2 * margin);
    const auto within = [](int place, int count) { return (place % count + count) % count; };
    for (int y = 0; y < wide.ny(); ++y) {
        for (int x = 0; x < wide.nx(); ++x)
            wide(x, y) = field(within(x - margin, nx), within(y - margin, ny));
    }
    return wide;
}

/// What lies inside a margin.
template <class Number>
Field<Number> without_margin(const Field<Number>& wide, int margin) {
    Field<Number> field(wide.nx() - 2 * margin, wide.ny() - 2 * margin);
    for (int y = 0; y < field.ny(); ++y) {
        for (int x = 0; x < field.nx(); ++x) field(x, y) = wide(x + margin, y + margin);
    }
    return field;
}

}  // namespace fumon
