#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

class KeyTable;

enum class DropChoice { in_turn, random };
enum class DropDirection { random, cycling };
enum class DirectionRule { mean, mean_rounded, circular_mean };
enum class ToppleToward { any_lower, toward_direction };
enum class ToppleOrder { sweep, first_in_first_out };

/// The parameters of the sandpile of Higashi & Takamori (2003). Heights are in grains.
struct SandpileParameters {
    std::vector<std::int64_t> drop_x;  ///< grid coordinate eastward; empty: the paper's centre
    std::vector<std::int64_t> drop_y;  ///< grid coordinate northward, one for each drop_x
    DropChoice drop_choice = DropChoice::in_turn;
    DropDirection drop_direction = DropDirection::random;
    std::int64_t grains_per_step = 1;

    std::int64_t threshold = 5;          ///< T: heights; section 2.2.2
    std::int64_t grains_per_topple = 3;  ///< g; eq. (2)
    DirectionRule direction = DirectionRule::mean;
    ToppleToward topple_toward = ToppleToward::any_lower;
    ToppleOrder order = ToppleOrder::sweep;
};

/// Lists the keys model.* bound to these parameters.
void list_keys(SandpileParameters& parameters, KeyTable& table);

}  // namespace fumon
