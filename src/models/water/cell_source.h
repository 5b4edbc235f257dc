#pragma once

#include "models/water/gully_parameters.h"

namespace fumon {

/// Where the cell at `index`, possibly beyond the edges, takes its values from.
struct CellSource {
    int index = 0;
    bool mirrored = false;
    bool outside = false;
};

inline CellSource source_of(int index, int count, EdgeKind edges) {
    if (index >= 0 && index < count) return {index, false, false};
    if (edges == EdgeKind::open) return {0, false, true};
    if (edges == EdgeKind::wall) {
        const int twice = 2 * count;
        const int folded = ((index % twice) + twice) % twice;
        if (folded < count) return {folded, false, false};
        return {twice - 1 - folded, true, false};
    }
    return {((index % count) + count) % count, false, false};
}

}  // namespace fumon
