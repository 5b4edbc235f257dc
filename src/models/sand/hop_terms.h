#pragma once

#include <algorithm>

#include "base/elementary.h"
#include "models/sand/sand_parameters.h"

namespace fumon {

/// The slope at a cell of height `here`, of the heights upwind and downwind of it.
inline double slope_at(SlopeDifference difference, double upwind, double here, double downwind) {
    switch (difference) {
        case SlopeDifference::central:
            return 0.5 * (downwind - upwind);
        case SlopeDifference::backward:
            return here - upwind;
        case SlopeDifference::forward:
            return downwind - here;
    }
    return 0.0;
}

/// What a hop takes from a height with a slope, by SandParameters; its shadow is not asked for.
inline double hop_amount(const SandParameters& p, double height, double slope) {
    double carried = p.amount;
    if (p.hop_amount == HopAmount::slope)
        carried = std::max(0.0, p.amount + p.amount_slope_factor * elementary::tanh(slope));
    if (p.limit_amount) carried = carried < height ? carried : height;
    return carried;
}

}  // namespace fumon
