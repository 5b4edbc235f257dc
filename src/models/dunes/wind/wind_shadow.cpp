// The wind shadow by lines that follow the wind over the grid (the rule stands in wind_shadow.h).
//
//        wind ->      crest
//                    _/ \`-._`-._
//                  _/    \   `-._ `-._           soft: the surface at the soft angle
//                _/       \      `-._  `-._      full: the surface at the full angle
//          _____/          \_________`-.___`-.____
//                                   full   soft
//
//    Shadow is 1 below the surface at the full angle, and 0 above the surface at the soft angle.
//
// 1. No cell looks upwind. A line carries both surfaces with it, lets them fall from row to row and
//    lifts them to the ground that it passes: the work is a few operations a cell, however far
//    shadows reach.
// 2. The rows that lines cross are the grid's rows or columns, whichever the wind meets more
//    steeply (RowTraversal), so that lines shift by a cell at most from row to row. Lines are a
//    cell apart; heights between cells are linear, and a cell takes what the lines beside it find.
// 3. 64 lines go side by side, as vectors, 32 rows at a time. Where the wind blows along x these
//    rows are columns, far apart in memory; so cells are gathered and scattered through a buffer:
//
//        grid, x fastest                       buffer
//        y |   32 columns of 64 cells     |    heights[k][i]   k: row across the wind
//          |   gather_heights ->          |                    i: line
//          |   <- scatter_to_cells        |    and then the shade in the same place
//
// 4. In a periodic bed lines start as far upwind as a shadow can reach (relief over the drop of the
//    soft surface a row), at most once round; those rows get no shade.
// 5. Lines depend on nothing but the ground, so threads share them and results do not depend on
//    how many there are.

#include "models/dunes/wind/wind_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "base/cancellation.h"
#include "base/worker_pool.h"
#include "models/dunes/wind/row_traversal.h"
#include "models/dunes/wind/shadow_vectors.h"

namespace fumon {

namespace {

constexpr double below_all_ground = -1e30;  // m

/// Lines that go side by side: few, so that what is known of them stays in the nearest caches.
constexpr int lines_at_once = 64;
/// Rows along the wind whose cells are fetched and given back together, which lie side by side in
/// memory where the wind blows along x.
constexpr int rows_at_once = 32;
/// Room behind the lines, so that vectors end with them.
constexpr int widest_vector = 8;

/// Where lines stand in a row of cells across the wind: the first at `cell`, the others next to it.
struct LineSpan {
    int row;
    std::int64_t cell;
    double beyond;  ///< of a cell, by which they stand farther
};

/// Where stretches are columns of the grid, calls row(cell, y) for each cell across the wind at
/// which one of their lines stands: y is its row of the grid, −1 past an open edge. And coming(y)
/// for rows that it comes to soon.
template <class Row, class Coming>
void for_each_row_of_columns(const RowTraversal& traversal, std::span<const LineSpan> line_spans,
                             int count, const Row& row, const Coming& coming) {
    const auto [first, last] = std::ranges::minmax(line_spans, {}, &LineSpan::cell);
    const auto y_of = [&](std::int64_t cell) {
        if (traversal.periodic_across)
            return static_cast<int>((cell % traversal.across + traversal.across) %
                                    traversal.across);
        return cell < 0 || cell >= traversal.across ? -1 : static_cast<int>(cell);
    };
    constexpr int soon = 4;
    for (std::int64_t cell = first.cell; cell < last.cell + count; ++cell) {
        if (const int y = y_of(cell + soon); y >= 0) coming(y);
        row(cell, y_of(cell));
    }
}

/// Calls piece(i, x, size) for the pieces of a stretch along a row of the grid, which goes on with
/// the other side of a periodic one: its cells from i on stand at x, −1 past an open edge.
template <class Piece>
void for_each_piece(const RowTraversal& traversal, const LineSpan& line_span, int count,
                    const Piece& piece) {
    const std::int64_t across = traversal.across;
    for (int i = 0; i < count;) {
        const std::int64_t cell = line_span.cell + i;
        const std::int64_t at =
            traversal.periodic_across ? (cell % across + across) % across : cell;
        const bool inside = at >= 0 && at < across;
        const std::int64_t room = inside ? across - at : at < 0 ? -at : count;
        const int size = static_cast<int>(std::min<std::int64_t>(room, count - i));
        piece(i, inside ? static_cast<int>(at) : -1, size);
        i += size;
    }
}

/// The ground under lines, metres; past an open edge that of the last cell.
template <class Heights>
void gather_heights(const FixedPointGrid& surface, const RowTraversal& traversal,
                    std::span<const LineSpan> line_spans, int count, Heights& heights) {
    const auto edge_of = [&](std::int64_t cell) { return cell < 0 ? 0 : traversal.across - 1; };
    if (!traversal.turned) {
        for (std::size_t k = 0; k < line_spans.size(); ++k) {
            const int y = line_spans[k].row;
            for_each_piece(traversal, line_spans[k], count, [&](int i, int x, int size) {
                if (x >= 0) {
                    shadow_vectors::to_metres(&surface(x, y), size,
                                              &heights[k][static_cast<std::size_t>(i)]);
                } else {
                    std::fill_n(&heights[k][static_cast<std::size_t>(i)], size,
                                to_metres(surface(edge_of(line_spans[k].cell + i), y)));
                }
            });
        }
        return;
    }

    std::array<double, rows_at_once> metres{};
    const auto size = static_cast<int>(line_spans.size());
    const int x = std::ranges::min(line_spans, {}, &LineSpan::row).row;
    for_each_row_of_columns(
        traversal, line_spans, count,
        [&](std::int64_t cell, int y) {
            shadow_vectors::to_metres(&surface(x, y >= 0 ? y : edge_of(cell)), size, metres.data());
            for (std::size_t k = 0; k < line_spans.size(); ++k) {
                const auto i = static_cast<std::uint64_t>(cell - line_spans[k].cell);
                if (i < static_cast<std::uint64_t>(count))
                    heights[k][i] = metres[static_cast<std::size_t>(line_spans[k].row - x)];
            }
        },
        [&](int y) {
            for (int line = x; line < x + size; line += cells_of_cache_line)
                __builtin_prefetch(&surface(line, y));
        });
}

/// Puts what was found between lines into their cells.
template <class Found>
void scatter_to_cells(const Found& found, const RowTraversal& traversal,
                      std::span<const LineSpan> line_spans, int count, Grid& grid) {
    if (!traversal.turned) {
        for (std::size_t k = 0; k < line_spans.size(); ++k) {
            for_each_piece(traversal, line_spans[k], count, [&](int i, int x, int size) {
                if (x >= 0)
                    std::copy_n(&found[k][static_cast<std::size_t>(i)], size,
                                &grid(x, line_spans[k].row));
            });
        }
        return;
    }
    const int x = std::ranges::min(line_spans, {}, &LineSpan::row).row;
    const auto size = static_cast<int>(line_spans.size());
    for_each_row_of_columns(
        traversal, line_spans, count,
        [&](std::int64_t cell, int y) {
            if (y < 0) return;
            double* row = grid.row(y).data();
            for (std::size_t k = 0; k < line_spans.size(); ++k) {
                const auto i = static_cast<std::uint64_t>(cell - line_spans[k].cell);
                if (i < static_cast<std::uint64_t>(count)) row[line_spans[k].row] = found[k][i];
            }
        },
        [&](int y) {
            for (int line = x; line < x + size; line += cells_of_cache_line)
                __builtin_prefetch(&grid(line, y), 1);
        });
}

}  // namespace

WindShadow::WindShadow(const DuneGround& ground, WorkerPool& pool)
    : ground_(ground),
      pool_(pool),
      shade_(ground.nx, ground.ny),
      envelope_(ground.nx, ground.ny),
      lowest_(static_cast<std::size_t>(ground.ny)),
      highest_(static_cast<std::size_t>(ground.ny)) {}

void WindShadow::cast(const FixedPointGrid& surface, const BlowingWind& wind,
                      const ShadowTangents& tangents, Find find) {
    const RowTraversal traversal(ground_, wind);
    rows_before_ = traversal.periodic_along ? rows_of_reach(surface, traversal, tangents) : 0;
    const int lines = traversal.lines();
    pool_.for_ranges(lines, [&](int begin, int end) {
        for (int first = begin; first < end; first += lines_at_once)
            follow_lines(surface, traversal, tangents, find, first,
                         std::min(first + lines_at_once, end));
    });
}

int WindShadow::rows_of_reach(const FixedPointGrid& surface, const RowTraversal& traversal,
                              const ShadowTangents& tangents) {
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const auto row = static_cast<std::size_t>(y);
            shadow_vectors::range_of_row(surface.row(y).data(), ground_.nx, lowest_[row],
                                         highest_[row]);
        }
    });
    const double relief = to_metres(*std::ranges::max_element(highest_)) -
                          to_metres(*std::ranges::min_element(lowest_));
    const double soft_drop = tangents.soft * traversal.distance;
    return static_cast<int>(std::min<double>(std::ceil(relief / soft_drop) + 1.0, traversal.along));
}

void WindShadow::follow_lines(const FixedPointGrid& surface, const RowTraversal& traversal,
                              const ShadowTangents& tangents, Find find, int first, int last) {
    const double base = traversal.first_cell();
    const shadow_vectors::Fall fall{traversal.distance, tangents.soft * traversal.distance,
                                    tangents.full * traversal.distance};
    const int count = last - first + 1;
    constexpr std::size_t room = lines_at_once + 1 + widest_vector;
    using OfLines = std::array<double, room>;
    OfLines soft{};
    OfLines full{};
    OfLines since{};
    soft.fill(below_all_ground);
    full.fill(below_all_ground);
    const shadow_vectors::Lines lines{soft.data(), full.data(), since.data(), count};
    std::array<OfLines, rows_at_once> heights{};  // and then the shade
    std::array<OfLines, rows_at_once> envelope{};
    std::array<LineSpan, rows_at_once> rows{};
    const bool with_envelope = find == Find::shade_and_envelope;
    for (int begin = -rows_before_; begin < traversal.along;) {
        throw_if_cancelled();
        const int end = std::min(begin + rows_at_once, begin < 0 ? 0 : traversal.along);
        const std::span line_spans(rows.data(), static_cast<std::size_t>(end - begin));
        for (int n = begin; n < end; ++n) {
            const double at = base + traversal.shift * n;
            const double cell = std::floor(at);
            rows[static_cast<std::size_t>(n - begin)] = {
                traversal.row(n), first - 1 + static_cast<std::int64_t>(cell), at - cell};
        }
        gather_heights(surface, traversal, line_spans, count + 1, heights);
        for (std::size_t k = 0; k < line_spans.size(); ++k) {
            shadow_vectors::advance_lines(lines, fall, {heights[k].data(), line_spans[k].beyond},
                                          tangents.full - tangents.soft,
                                          begin < 0 ? nullptr : heights[k].data(),
                                          with_envelope ? envelope[k].data() : nullptr);
        }
        if (begin >= 0) {
            for (LineSpan& line_span : line_spans) ++line_span.cell;
            scatter_to_cells(heights, traversal, line_spans, count - 1, shade_);
            if (with_envelope)
                scatter_to_cells(envelope, traversal, line_spans, count - 1, envelope_);
        }
        begin = end;
    }
}

}  // namespace fumon
