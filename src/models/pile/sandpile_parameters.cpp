#include "models/pile/sandpile_parameters.h"

#include "base/limits.h"
#include "keys/keys.h"

namespace fumon {

void list_keys(SandpileParameters& pile, KeyTable& table) {
    constexpr double most_grains_per_step = 1e9;
    constexpr double highest_threshold = 1000;
    table.integer_list("model.drop_x", pile.drop_x,
                       {.unit = "cells",
                        .range = {0, largest_grid_side - 1},
                        .help = "where grains fall, eastward from 0: one number a site; empty is "
                                "nx/2, the paper's centre"});
    table.integer_list("model.drop_y", pile.drop_y,
                       {.unit = "cells",
                        .range = {0, largest_grid_side - 1},
                        .help = "where grains fall, northward from 0, as many as model.drop_x; "
                                "empty is ny-1-ny/2, the paper's centre"});
    table.choice("model.drop_choice", pile.drop_choice,
                 {{DropChoice::in_turn, "in-turn", "site after site, as listed"},
                  {DropChoice::random, "random", "a site drawn anew for every grain"}},
                 {.help = "on which site the next grain falls"});
    table.choice("model.drop_direction", pile.drop_direction,
                 {{DropDirection::random, "random",
                   "uniform over the 8 (Higashi & Takamori 2003, section 3.2.1)"},
                  {DropDirection::cycling, "cycling",
                   "1, 2 ... 8, 1 ...: no randomness, for checking implementations"}},
                 {.help = "direction that a drop site, or a cell without one, takes to topple"});
    table.integer("model.grains_per_step", pile.grains_per_step,
                  {.unit = "grains",
                   .range = {1, most_grains_per_step},
                   .help = "grains of a step, dropped one by one, each after rest"});
    table.integer("model.threshold", pile.threshold,
                  {.unit = "heights",
                   .range = {1, highest_threshold},
                   .help = "T: a cell topples when a neighbour is lower by this or more; 5 in the "
                           "paper, 1 admits no topple"});
    table.integer("model.grains_per_topple", pile.grains_per_topple,
                  {.unit = "grains",
                   .range = {1, highest_threshold},
                   .help = "g: grains that a topple moves (3 in the paper), shared evenly by 3 "
                           "cells; at most 1 for T = 2, 2 for T = 3, 3 for T = 4 and 5: g + "
                           "ceil(g/3) <= T; 1 keeps grains on the 8 rays from a drop site"});
    table.choice(
        "model.direction", pile.direction,
        {{DirectionRule::mean, "mean",
          "trunc((B + B_R)/2) with table 2's exceptions, B_R where B is 0 (eqs. 4, 5); biased: the "
          "pile drifts"},
         {DirectionRule::mean_rounded, "mean-rounded",
          "as table 3 prints it: halves rounded up, a B of 0 averaged too"},
         {DirectionRule::circular_mean, "circular-mean",
          "halfway on the circle, halves toward B_R: a round cone, little drift"}},
        {.help = "how a cell that receives a grain going B_R turns its own direction B (Higashi & "
                 "Takamori 2003, section 3.2.3)"});
    table.choice("model.topple_toward", pile.topple_toward,
                 {{ToppleToward::any_lower, "any-lower",
                   "where any of the 8 neighbours is low enough (the paper)"},
                  {ToppleToward::toward_direction, "toward-direction",
                   "only where one of the cells that would get its grains is; drop sites and cells "
                   "without a direction look at all 8"}},
                 {.help = "which lower neighbours make a cell topple"});
    table.choice(
        "model.order", pile.order,
        {{ToppleOrder::sweep, "sweep",
          "row by row from the north-west, in place, once a visit, again and again until rest"},
         {ToppleOrder::first_in_first_out, "first-in-first-out",
          "by a queue: the cell at its front leaves it and topples once if it is unstable; then "
          "those of the 3 x 3 cells around it and itself that are unstable and not in the queue "
          "join its end, row by row from the north-west; a dropped grain's cell begins it, the "
          "first bed's unstable cells do so row by row. Other rules of joining move the grains "
          "that stay by some 5 %"}},
        {.help = "order of toppling; the paper does not say, and a large pile depends on it"});
}

}  // namespace fumon
