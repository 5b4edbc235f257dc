#include "models/sand/sand_parameters.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "keys/keys.h"
#include "models/sand/creep.h"

namespace fumon {

void list_keys(SandParameters& sand, KeyTable& table) {
    constexpr double longest_hop = 1e6;
    constexpr double largest_base = 1e30;  // many hops from a low bed: a^(2 h0) is what counts
    constexpr std::size_t longest_table = 100000;
    table.choice("model.order", sand.order,
                 {{HopOrder::synchronous, "synchronous",
                   "every cell hops once, all from the bed before the step (Terada 2024, 2025)"},
                  {HopOrder::random_sequential, "random-sequential",
                   "as many random cells as there are, one after the other (Sudo 2002)"}},
                 {.help = "order of hops within a step"});
    table.choice(
        "model.hop_length", sand.hop_length,
        {{HopLength::linear, "linear", "L = L0 + b h (Nishimori & Ouchi 1993; Sudo 2002)"},
         {HopLength::slope, "slope", "L = L0 - alpha tanh(dh/dx): the dune rule (Terada 2024)"},
         {HopLength::exponential, "exponential",
          "L = (N'x/10) (a^(2 h0 h) - 1) / (a^(2 h0) - 1) (Terada 2025, eq. 45)"},
         {HopLength::tabulated, "tabulated",
          "from a table of heights and lengths, linear between its points"}},
        {.help = "how far sand hops from height h"});
    table.real(
        "model.hop_base", sand.hop_base,
        {.unit = "sites",
         .range = {-longest_hop, longest_hop},
         .help = "L0 of the linear and slope laws: the wind's strength; no hop goes upwind"});
    table.real(
        "model.hop_per_height", sand.hop_per_height,
        {.unit = "sites per height", .range = {0, longest_hop}, .help = "b of the linear law"});
    table.real("model.hop_slope_factor", sand.hop_slope_factor,
               {.unit = "sites",
                .range = {0, longest_hop},
                .help = "alpha of the slope law; no hop goes upwind"});
    table.real(
        "model.exponential_base", sand.exponential_base,
        {.unit = "per mm", .range = {1, largest_base, true}, .help = "a of the exponential law"});
    table.real("model.exponential_height", sand.exponential_height,
               {.unit = "mm",
                .range = {0, 1000, true},
                .help = "h0 of the exponential law; one model height is 2 h0"});
    table.real("model.exponential_length", sand.exponential_length,
               {.unit = "sites",
                .range = {0, longest_hop, true},
                .help = "N'x of the exponential law; 100 on any grid"});
    table.real_list("model.hop_table_heights", sand.hop_table_heights, 0, longest_table,
                    {.unit = "heights",
                     .range = {-largest_height, largest_height},
                     .help = "of the tabulated law: heights, rising; beyond the ends the length "
                             "stays"});
    table.real_list("model.hop_table_lengths", sand.hop_table_lengths, 0, longest_table,
                    {.unit = "sites",
                     .range = {0, longest_hop},
                     .help = "of the tabulated law: the hop length at each of these heights"});
    table.choice("model.landing", sand.landing,
                 {{Landing::truncate, "truncate", "in the cell that the truncated length reaches"},
                  {Landing::round, "round", "in the nearest cell"},
                  {Landing::split, "split", "shared between the two nearest cells"},
                  {Landing::truncate_terms, "truncate-terms",
                   "b h truncated by itself, then the sum (Sudo's program)"}},
                 {.help = "how a length becomes a cell"});
    table.choice(
        "model.hop_amount", sand.hop_amount,
        {{HopAmount::constant, "constant", "q = q0"},
         {HopAmount::slope, "slope", "q = q0 + beta tanh(dh/dx): the dune rule (Terada 2024)"}},
        {.help = "how much sand a hop carries"});
    table.real("model.amount", sand.amount, {.unit = "heights", .range = {0, 1000}, .help = "q0"});
    table.real(
        "model.amount_slope_factor", sand.amount_slope_factor,
        {.unit = "heights", .range = {0, 1000}, .help = "beta; no hop carries less than nothing"});
    table.boolean("model.limit_amount", sand.limit_amount,
                  {.help = "never carry more than is there; false is Sudo's program (the bed dips "
                           "to about -0.1)"});
    table.choice("model.slope_difference", sand.slope_difference,
                 {{SlopeDifference::central, "central", "(h(x+1) - h(x-1)) / 2"},
                  {SlopeDifference::backward, "backward", "h(x) - h(x-1): upwind"},
                  {SlopeDifference::forward, "forward", "h(x+1) - h(x): downwind"}},
                 {.help = "how dh/dx is taken"});
    table.choice(
        "model.creep", sand.creep,
        {{Creep::every_cell, "every-cell",
          "every cell shares D of itself with its 8 neighbours (Sudo's eq. 3)"},
         {Creep::maxima_only, "maxima-only",
          "strict maxima give D h away, in place and in order (Sudo's program)"},
         {Creep::profile, "profile",
          "each row by itself: strict maxima of two neighbours give D h, flanks E h downhill, in "
          "place from left to right (Sudo 2002, section 5)"},
         {Creep::none, "none", "hops alone"}},
        {.help = "how sand rolls after the hops"});
    table.real(
        "model.creep_rate", sand.creep_rate,
        {.unit = "share per step",
         .range = {0, 1, true},
         .help = fmt::format("D; at most {} for every-cell creep", highest_every_cell_creep_rate)});
    table.real("model.flank_rate", sand.flank_rate,
               {.unit = "share per step",
                .range = {0, 1},
                .help = "E of the profile's creep (in Sudo's program only)"});
    table.choice("model.shadow", sand.shadow,
                 {{Shadow::none, "none", "wind everywhere"},
                  {Shadow::upwind_higher, "upwind-higher",
                   "no hop where the cell next upwind is higher (Sudo 2002, section 4.2)"}},
                 {.help = "where the wind does not reach"});
}

}  // namespace fumon
