#pragma once

#include <algorithm>

#include "base/grid.h"

namespace fumon {

/// A periodic field with `margin` of its own cells again on each side.
template <class Number>
Field<Number> with_margin(const Field<Number>& field, int margin) {
    const int nx = field.nx();
    const int ny = field.ny();
    Field<Number> wide(nx + 2 * margin, ny + 2 * margin);
    const auto within = [](int position, int count) { return (position % count + count) % count; };
    for (int y = 0; y < wide.ny(); ++y) {
        const auto from = field.row(within(y - margin, ny));
        const auto to = wide.row(y);
        for (int x = 0; x < wide.nx();) {
            const int first = within(x - margin, nx);
            const int count = std::min(nx - first, wide.nx() - x);
            std::copy_n(from.begin() + first, count, to.begin() + x);
            x += count;
        }
    }
    return wide;
}

/// The same periodic field that begins so many cells farther east and north.
template <class Number>
Field<Number> rolled(const Field<Number>& field, int east, int north) {
    const auto within = [](int position, int count) { return (position % count + count) % count; };
    Field<Number> result(field.nx(), field.ny());
    for (int y = 0; y < field.ny(); ++y) {
        const auto from = field.row(within(y + north, field.ny()));
        std::rotate_copy(from.begin(), from.begin() + within(east, field.nx()), from.end(),
                         result.row(y).begin());
    }
    return result;
}

/// What lies inside a margin.
template <class Number>
Field<Number> without_margin(const Field<Number>& wide, int margin) {
    Field<Number> field(wide.nx() - 2 * margin, wide.ny() - 2 * margin);
    for (int y = 0; y < field.ny(); ++y)
        std::copy_n(wide.row(y + margin).begin() + margin, field.nx(), field.row(y).begin());
    return field;
}

}  // namespace fumon
