#pragma once

#include <array>
#include <cstdint>

#include "models/pile/sandpile_parameters.h"

namespace fumon {

// What one topple does, by Higashi & Takamori (2003), sections 2.2 and 3.2. Directions are their
// table 1: 1 = up-left and clockwise on to 8 = left, in arrays whose Y grows downward (north-west
// and clockwise to west on a map); 0 = none yet.
inline constexpr int no_direction = 0;
inline constexpr int direction_count = 8;

/// One cell further: X to the right (east), Y downward (south).
struct RingStep {
    int dx;
    int dy;
};

/// The step in a direction of 1 … 8.
RingStep ring_step(int direction);

/// The direction `eighths` further clockwise on the ring of 1 … 8.
int turned(int direction, int eighths);

/// B': the direction of a cell after it has received grains.
///
///     mean           B' = trunc((B + B_R)/2)   (eq. 4), but 8 for {1,8}, {1,7} and {2,7},
///                    1 for {2,8} and {3,8}, 7 for {1,6} (table 2, either order: all pairs that lie
///                    5 or more apart as numbers), and B_R where B is 0 (eq. 5)
///     mean-rounded   halves rounded up, and a B of 0 averaged like any other, which is how table 3
///                    gets 2, 3, 3 from B = 0 and B_R = 4, 5, 6, against eq. (5) and table 2;
///                    table 2's exceptions hold
///     circular-mean  halfway on the circle of eighths. Half an eighth goes to either side with
///                    equal chance (`half_step`, see TopplingDraws::toss): always rounded to the
///                    same side, even toward B_R, piles stand crooked. Opposite directions, which
///                    have no mean, give B_R. The rule is the same seen in a mirror or turned, so
///                    it has no bias of its own. Not the paper's.
///
/// `before` is B, 0 … 8; `incoming` is B_R, 1 … 8: the direction in which the grain came.
enum class HalfStep { toward_incoming, toward_previous };
int direction_after(DirectionRule rule, int before, int incoming,
                    HalfStep half_step = HalfStep::toward_incoming);

/// How g grains fall on the three cells around B, counter-clockwise neighbour first: g/3 each; one
/// left over goes to B's own cell, two go to its neighbours. One grain each for g = 3, as
/// published.
std::array<int, 3> shares_of(int grains);

/// The most grains that a topple may move at threshold T; 0 if it may move none.
///
/// A topple must not undercut its own cell: the cell, at h, falls to h − g, and a cell that it
/// topples toward because that lay at h − T or lower rises to h − T + ⌈g/3⌉ at most, ⌈g/3⌉ being
/// the most that one cell gets. The first is not below the second for every such pair just when
///
///     g + ⌈g/3⌉ ≤ T:     T = 1: none;  2: 1;  3: 2;  4 and 5: 3;  6: 4;  7: 5;  8 and 9: 6; …
///
/// Without it a cell would make its receiver overhang it, and grains would be tossed to and fro.
/// It says nothing of the three cells that are not T lower: the published rule moves grains along
/// B, uphill too.
std::int64_t most_grains_per_topple(std::int64_t threshold);

}  // namespace fumon
