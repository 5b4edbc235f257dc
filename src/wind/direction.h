#pragma once

namespace fumon {

// Degrees clockwise from north.

inline constexpr double full_turn = 360.0;
inline constexpr double half_turn = 180.0;

/// Where a wind blows to that comes from a direction from 0 up to 360, and back.
inline double opposite(double direction) {
    return direction >= half_turn ? direction - half_turn : direction + half_turn;
}

}  // namespace fumon
