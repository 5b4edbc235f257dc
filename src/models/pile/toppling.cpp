#include "models/pile/toppling.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

namespace {

/// Table 2, for the smaller and the larger of the two directions; 0 where it has no entry.
int exception_of_table_2(int smaller, int larger) {
    if (larger == 8 && smaller == 1) return 8;
    if (larger == 8 && (smaller == 2 || smaller == 3)) return 1;
    if (larger == 7 && (smaller == 1 || smaller == 2)) return 8;
    if (larger == 6 && smaller == 1) return 7;
    return 0;
}

int published_mean(int before, int incoming, int added_before_halving) {
    const int exception =
        exception_of_table_2(std::min(before, incoming), std::max(before, incoming));
    return exception != 0 ? exception : (before + incoming + added_before_halving) / 2;
}

int circular_mean(int before, int incoming, HalfStep half_step) {
    constexpr int half_turn = direction_count / 2;
    const int rounded = half_step == HalfStep::toward_incoming ? 1 : 0;
    const int clockwise = (incoming - before + direction_count) % direction_count;
    if (clockwise == half_turn) return incoming;
    return clockwise < half_turn ? turned(before, (clockwise + rounded) / 2)
                                 : turned(before, -((direction_count - clockwise + rounded) / 2));
}

}  // namespace

RingStep ring_step(int direction) {
    static constexpr std::array<RingStep, direction_count> ring{
        {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};
    return ring[static_cast<std::size_t>(direction - 1)];
}

int turned(int direction, int eighths) {
    return (direction - 1 + eighths + direction_count) % direction_count + 1;
}

int direction_after(DirectionRule rule, int before, int incoming, HalfStep half_step) {
    if (rule == DirectionRule::mean_rounded) return published_mean(before, incoming, 1);
    if (before == no_direction) return incoming;
    return rule == DirectionRule::mean ? published_mean(before, incoming, 0)
                                       : circular_mean(before, incoming, half_step);
}

std::array<int, 3> shares_of(int grains) {
    const int each = grains / 3;
    const int left_over = grains % 3;
    const int flank = each + (left_over == 2 ? 1 : 0);
    return {flank, each + (left_over == 1 ? 1 : 0), flank};
}

std::int64_t most_grains_per_topple(std::int64_t threshold) {
    const auto undercuts = [&](std::int64_t grains) {
        return grains + (grains + 2) / 3 > threshold;
    };
    std::int64_t most = 0;
    while (!undercuts(most + 1)) ++most;
    return most;
}

}  // namespace fumon
