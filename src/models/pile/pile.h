#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "models/pile/sandpile_parameters.h"
#include "models/pile/toppling_draws.h"
#include "models/shared/cell_set.h"
#include "models/shared/model.h"

namespace fumon {

class StateArchive;

/// A cell of the grid: x eastward, y northward, from 0.
struct Site {
    int x = 0;
    int y = 0;
};

/// A pile of grains on nx × ny cells and its toppling: heights, directions and what the last
/// avalanche touched. One grain weighs one height. Around the cells lies an edge of height 0 that
/// swallows what falls on it.
///
/// A sweep visits the cells in the paper's array order (rows from the north, each from the west) in
/// place, and a visited cell that is unstable topples once. Only cells that may be unstable wait
/// for a visit: those that received grains, and those that a topple left unstable. Cells ahead of
/// the sweep are still visited in it, those behind in the next, so the result is that of visiting
/// every cell in every sweep, at a cost per topple that hardly depends on the size of the grid.
///
/// First in, first out: the cell at the front of a queue leaves it and topples once, if it is
/// unstable; then the 3 × 3 cells around and including it join the end in array order, each if it
/// is unstable and not in the queue. Which cells join when matters a little: other orders of
/// joining change the grains resident on 64 × 64 cells by some 5 %.
class Pile {
  public:
    /// `bed`: whole heights ≥ 0, below 2^26. `apexes`: the drop sites, whose direction is drawn
    /// anew at every topple.
    Pile(const SandpileParameters& parameters, const Grid& bed, std::span<const Site> apexes);

    /// Topples until no cell is unstable, which the given bed may be. No avalanche: changes() are
    /// 0.
    std::int64_t settle(TopplingDraws& draws);

    /// Drops one grain on a cell of a pile at rest and topples until no cell is unstable. An
    /// avalanche of size 0 if the grain set off no toppling.
    Avalanche drop(Site site, TopplingDraws& draws);

    /// Grains that have left over the edge so far.
    [[nodiscard]] std::int64_t lost() const { return lost_; }

    /// Heights, nx × ny, row 0 southernmost.
    [[nodiscard]] Grid heights() const;

    /// Directions by table 1: 0 = none yet, 1 … 8, 9 = drop site. nx × ny.
    [[nodiscard]] Grid directions() const;

    /// What the last avalanche did to each cell: 0 nothing, 1 it received grains,
    /// 1 + n it toppled n times. nx × ny.
    [[nodiscard]] Grid changes() const;

    /// Saves or restores a pile at rest (or as it was given, before it settles): heights,
    /// directions and what the last avalanche touched.
    void serialise(StateArchive& archive);

  private:
    struct Receiver {
        std::ptrdiff_t offset;
        int direction;
        std::int32_t given;
    };

    [[nodiscard]] std::size_t cell_of(Site site) const;
    template <class Value>
    [[nodiscard]] Grid grid_of(Value value) const;

    [[nodiscard]] bool unstable(std::size_t cell) const;
    template <bool toward_direction>
    [[nodiscard]] bool unstable_by(std::size_t cell) const;
    [[nodiscard]] bool any_neighbour_at_most(std::size_t cell, std::int32_t limit) const;
    void note_change(std::size_t cell, std::uint32_t change);
    void reset_changes();
    Avalanche topple_until_rest(TopplingDraws& draws);
    template <bool toward_direction>
    void sweep_until_rest(TopplingDraws& draws, Avalanche& avalanche);
    void drain_queue(TopplingDraws& draws, Avalanche& avalanche);
    template <class Received>
    void topple(std::size_t cell, TopplingDraws& draws, Received received);

    int nx_;
    int ny_;
    std::ptrdiff_t stride_;  ///< cells of a row with its two edges
    bool toward_direction_;
    ToppleOrder order_;
    std::int32_t threshold_;                                    ///< as packed heights
    std::int32_t moved_;                                        ///< by a topple, as packed heights
    std::array<std::ptrdiff_t, 8> around_{};                    ///< the ring, direction 1 first
    std::array<std::ptrdiff_t, 9> block_{};                     ///< 3 × 3, in array order
    std::array<std::array<Receiver, 3>, 9> receivers_{};        ///< by direction 1 … 8
    using Turns = std::array<std::array<std::int32_t, 9>, 10>;  ///< B' by B (0 … 9), B_R (1 … 8)
    Turns after_{};                                             ///< half steps toward B_R …
    Turns after_previous_{};                                    ///< … and toward B
    bool has_half_steps_ = false;
    /// 16 · height + direction, rows from the north with an edge all round. Heights are compared
    /// packed: h ≤ H just when 16·h + direction ≤ 16·H + 15.
    std::vector<std::int32_t> cells_;
    std::vector<std::uint32_t> changes_;  ///< see changes()
    std::vector<std::size_t> changed_;    ///< cells whose changes_ is not 0
    CellSet waiting_;                     ///< every unstable cell is in it
    std::vector<std::size_t> queue_;      ///< first in, first out: this generation
    std::vector<std::size_t> next_queue_;
    std::int64_t lost_ = 0;
};

}  // namespace fumon
