#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/grid.h"
#include "models/avalanche/avalanche_floor.h"
#include "models/avalanche/cell_bitset.h"
#include "models/avalanche/row_slots.h"
#include "models/shared/fixed_point_lengths.h"

namespace fumon {

class WorkerPool;

/// The angles of repose of loose ground, degrees.
struct ReposeAngles {
    double resting = 33.0;  ///< static: a slope at rest beyond it begins to slide
    double moving = 33.0;   ///< dynamic: sliding ground comes to rest at it; at most `resting`
};

/// The ground that avalanches move: cells, how they lie, and what is beyond their edges.
struct AvalancheGround {
    int nx = 0;
    int ny = 0;
    double dx = 1.0;  ///< m
    double dy = 1.0;  ///< m
    bool periodic_x = true;
    bool periodic_y = true;  ///< nothing slides across an edge that is not periodic
};

/// Avalanches of loose ground down to the angle of repose, in whole numbers of 2⁻³² m.
///
/// The slope of a cell is the one-sided gradient of Godunov (Rouy & Tourin 1992),
///
///     s² = a² + b²,  a = max(h − h_west, h − h_east, 0) / dx,  b likewise across,
///
/// whose level sets round a drop are circles, where steps to eight neighbours make octagons. A cell
/// with s > tan θ gives to the lower neighbour along each axis
///
///     ¼ dx a (1 − tan θ / s)   and   ¼ dy b (1 − tan θ / s),
///
/// no more than it has above the floor: the nonlinear diffusion whose rest state is the
/// slope θ, taken with the largest step that is stable for any direction of the slope. All cells of
/// a pass read the ground before it. A pass looks at the cells that gave in the last one and at
/// their neighbours, since no other slope has grown; it goes on until no cell with loose ground is
/// steeper than its angle by more than `tolerance`. Loose ground is conserved exactly; bare floor
/// keeps any slope.
class SlopeRelaxation {
  public:
    /// Degrees by which slopes may exceed the angle of repose where avalanches have ended.
    static constexpr double tolerance = 0.4;

    SlopeRelaxation(const AvalancheGround& ground, const ReposeAngles& angles, WorkerPool& pool);

    /// Angles that differ from cell to cell, in degrees: moving ones, each with the same ratio of
    /// tan(resting) to tan(moving) as before.
    void set_moving_angles(const Grid& degrees);

    /// From here on remembers which cells slide.
    void track_slid_cells() { slid_ = CellBitset(nx(), ny()); }
    /// Calls body(x, y) for each cell that has slid since it was last asked, by the numbers of the
    /// rows; none unless they are remembered.
    template <class Body>
    void drain_slid_cells(const Body& body) {
        for (int y = 0; y < ny() && slid_.words() > 0; ++y) {
            CellBitset::Word* words = slid_.row(y);
            for (int w = 0; w < slid_.words(); ++w) {
                for (CellBitset::Word left = std::exchange(words[w], 0); left != 0;
                     left &= left - 1)
                    body(w * CellBitset::word_bits + std::countr_zero(left), y);
            }
        }
    }

    struct Outcome {
        int passes = 0;
        bool at_rest = true;  ///< false where `most_passes` did not suffice
    };

    /// Whether it is to be seen, after `most_passes`, that all is at rest; where it is not, the
    /// outcome may say that it is not.
    enum class RestCheck { required, skipped };

    /// Relaxes the whole surface; many passes go over the rows together (see PassWavefront). Where
    /// there is `prepare`, prepare(y) is called once for each row, by any thread, before it is
    /// looked at: it may change that row.
    Outcome relax(FixedPointGrid& surface, const AvalancheFloor& floor, int most_passes,
                  RestCheck rest_check = RestCheck::required,
                  const std::function<void(int y)>& prepare = {});

    /// Relaxes what some cells, and what slides from them, make too steep: cell after cell, first
    /// in first out, on one thread. Cells are numbered y·nx + x. False where it gave up after
    /// `most_moves`.
    bool relax_near(FixedPointGrid& surface, const FixedPointGrid& floor,
                    std::span<const std::size_t> cells, std::int64_t most_moves);

    /// The steepest one-sided slope of a cell with loose ground, degrees.
    [[nodiscard]] double steepest(const FixedPointGrid& surface, const FixedPointGrid& floor) const;

  private:
    /// What leaves a cell: along x and y, positive eastward and northward. Units.
    struct Slide {
        std::int64_t x = 0;
        std::int64_t y = 0;
        [[nodiscard]] bool any() const { return x != 0 || y != 0; }
    };

    /// How the rows are gone through: shared out in strips, one a thread.
    struct Plan {
        int strips;
        std::function<void(int y)> prepare;
    };

    /// The lower neighbours of a cell: falls in units, ways −1 or +1, 0 where none is lower.
    struct Falls {
        Falls() = default;
        Falls(std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north)
            : x(static_cast<double>(std::max({west, east, std::int64_t{0}}))),
              y(static_cast<double>(std::max({south, north, std::int64_t{0}}))),
              direction_x(x == 0.0       ? 0
                          : east >= west ? 1
                                         : -1),
              direction_y(y == 0.0         ? 0
                          : north >= south ? 1
                                           : -1) {}

        double x = 0.0;
        double y = 0.0;
        int direction_x = 0;
        int direction_y = 0;
    };

    [[nodiscard]] int west(int x) const { return x > 0 ? x - 1 : periodic_x() ? nx() - 1 : 0; }
    [[nodiscard]] int east(int x) const { return x < nx() - 1 ? x + 1 : periodic_x() ? 0 : x; }
    [[nodiscard]] int south(int y) const { return y > 0 ? y - 1 : periodic_y() ? ny() - 1 : 0; }
    [[nodiscard]] int north(int y) const { return y < ny() - 1 ? y + 1 : periodic_y() ? 0 : y; }
    /// The row of a number that may have gone once round.
    [[nodiscard]] int row_of(int y) const { return y < 0 ? y + ny() : y < ny() ? y : y - ny(); }
    [[nodiscard]] int nx() const { return ground_.nx; }
    [[nodiscard]] int ny() const { return ground_.ny; }
    [[nodiscard]] bool periodic_x() const { return ground_.periodic_x; }
    [[nodiscard]] bool periodic_y() const { return ground_.periodic_y; }

    [[nodiscard]] Falls falls_at(const FixedPointGrid& surface, int x, int y) const;
    [[nodiscard]] Slide slide_at(const FixedPointGrid& surface, const FixedPointGrid& floor, int x,
                                 int y, double start_ratio) const;
    [[nodiscard]] Slide slide_of(const Falls& falls, std::int64_t loose, double rest,
                                 double start_ratio) const;
    [[nodiscard]] double tangent_at(int x, int y) const {
        return moving_tangents_.empty() ? moving_tangent_ : moving_tangents_(x, y);
    }
    void mark_row(const FixedPointGrid& surface, int y);
    std::int64_t slide_row(const FixedPointGrid& surface, const AvalancheFloor& floor, int y,
                           double start_ratio);
    std::int64_t slide_row_in_pass(const FixedPointGrid& surface, const AvalancheFloor& floor,
                                   int y, int pass);
    void settle_row(FixedPointGrid& surface, int y);
    std::vector<std::int64_t> run_passes(FixedPointGrid& surface, const AvalancheFloor& floor,
                                         const Plan& plan, int done, int most);

    AvalancheGround ground_;
    WorkerPool& pool_;
    double moving_tangent_;
    double start_ratio_;      ///< of tangents: where ground at rest begins to slide, to tan(moving)
    double sliding_ratio_;    ///< where ground beside what slides begins to slide, to tan(moving)
    Grid moving_tangents_;    ///< of each cell; empty where all have the same
    double least_tangent_;    ///< of them all
    double slope_of_unit_x_;  ///< of a fall of one unit to the next cell
    double slope_of_unit_y_;
    CellBitset candidates_;  ///< cells to look at
    CellBitset sliding_;     ///< cells that give, this pass
    CellBitset slid_;        ///< cells that have given, where they are remembered
    CellBitset left_;        ///< of a row's cells those that vectors leave to a loop over cells
    Grid slides_x_;          ///< of the sliding cells, whole numbers; 0 of the others
    Grid slides_y_;
    std::vector<double> no_slides_;  ///< of a row beyond an edge
    RowSlots places_;                ///< of the rows of slides_x_ and slides_y_
    bool clears_slides_ = false;     ///< in the first pass, since others were left
    bool slides_left_ = false;       ///< by passes that did not come to rest
    std::vector<std::size_t> queue_;
    std::vector<std::uint8_t> queued_;
};

}  // namespace fumon
