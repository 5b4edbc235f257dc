#include "models/dunes/wind_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "base/give_up.h"
#include "base/worker_pool.h"
#include "models/dunes/shadow_vectors.h"

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
struct Stretch {
    int row;
    std::int64_t cell;
    double beyond;  ///< of a cell, by which they stand farther
};

/// Where stretches are columns of the grid, calls row(cell, y) for each cell across the wind at
/// which one of their lines stands: y is its row of the grid, −1 past an open edge. And coming(y)
/// for rows that it comes to soon.
template <class Way, class Row, class Coming>
void for_each_row_of_columns(const Way& way, std::span<const Stretch> stretches, int count,
                             const Row& row, const Coming& coming) {
    const auto [first, last] = std::ranges::minmax(stretches, {}, &Stretch::cell);
    const auto y_of = [&](std::int64_t cell) {
        if (way.periodic_across)
            return static_cast<int>((cell % way.across + way.across) % way.across);
        return cell < 0 || cell >= way.across ? -1 : static_cast<int>(cell);
    };
    constexpr int soon = 4;
    for (std::int64_t cell = first.cell; cell < last.cell + count; ++cell) {
        if (const int y = y_of(cell + soon); y >= 0) coming(y);
        row(cell, y_of(cell));
    }
}

/// Calls piece(i, x, size) for the pieces of a stretch along a row of the grid, which goes on with
/// the other side of a periodic one: its cells from i on stand at x, −1 past an open edge.
template <class Way, class Piece>
void for_each_piece(const Way& way, const Stretch& stretch, int count, const Piece& piece) {
    const std::int64_t across = way.across;
    for (int i = 0; i < count;) {
        const std::int64_t cell = stretch.cell + i;
        const std::int64_t at = way.periodic_across ? (cell % across + across) % across : cell;
        const bool inside = at >= 0 && at < across;
        const std::int64_t room = inside ? across - at : at < 0 ? -at : count;
        const int size = static_cast<int>(std::min<std::int64_t>(room, count - i));
        piece(i, inside ? static_cast<int>(at) : -1, size);
        i += size;
    }
}

/// The ground under lines, metres; past an open edge that of the last cell.
template <class Way, class Heights>
void fetch(const WholeGrid& surface, const Way& way, std::span<const Stretch> stretches, int count,
           Heights& heights) {
    const auto edge_of = [&](std::int64_t cell) { return cell < 0 ? 0 : way.across - 1; };
    if (!way.turned) {
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            const int y = stretches[k].row;
            for_each_piece(way, stretches[k], count, [&](int i, int x, int size) {
                if (x >= 0) {
                    shadow_vectors::to_metres(&surface(x, y), size,
                                              &heights[k][static_cast<std::size_t>(i)]);
                } else {
                    std::fill_n(&heights[k][static_cast<std::size_t>(i)], size,
                                to_metres(surface(edge_of(stretches[k].cell + i), y)));
                }
            });
        }
        return;
    }

    std::array<double, rows_at_once> metres{};
    const auto size = static_cast<int>(stretches.size());
    const int x = std::ranges::min(stretches, {}, &Stretch::row).row;
    for_each_row_of_columns(
        way, stretches, count,
        [&](std::int64_t cell, int y) {
            shadow_vectors::to_metres(&surface(x, y >= 0 ? y : edge_of(cell)), size, metres.data());
            for (std::size_t k = 0; k < stretches.size(); ++k) {
                const auto i = static_cast<std::uint64_t>(cell - stretches[k].cell);
                if (i < static_cast<std::uint64_t>(count))
                    heights[k][i] = metres[static_cast<std::size_t>(stretches[k].row - x)];
            }
        },
        [&](int y) {
            for (int line = x; line < x + size; line += cells_of_cache_line)
                __builtin_prefetch(&surface(line, y));
        });
}

/// Puts what was found between lines into their cells.
template <class Way, class Found>
void give_back(const Found& found, const Way& way, std::span<const Stretch> stretches, int count,
               Grid& grid) {
    if (!way.turned) {
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            for_each_piece(way, stretches[k], count, [&](int i, int x, int size) {
                if (x >= 0)
                    std::copy_n(&found[k][static_cast<std::size_t>(i)], size,
                                &grid(x, stretches[k].row));
            });
        }
        return;
    }
    const int x = std::ranges::min(stretches, {}, &Stretch::row).row;
    const auto size = static_cast<int>(stretches.size());
    for_each_row_of_columns(
        way, stretches, count,
        [&](std::int64_t cell, int y) {
            if (y < 0) return;
            double* row = grid.row(y).data();
            for (std::size_t k = 0; k < stretches.size(); ++k) {
                const auto i = static_cast<std::uint64_t>(cell - stretches[k].cell);
                if (i < static_cast<std::uint64_t>(count)) row[stretches[k].row] = found[k][i];
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

void WindShadow::cast(const WholeGrid& surface, const BlowingWind& wind,
                      const ShadowTangents& tangents, Find find) {
    const Way way = way_of(wind);
    rows_before_ = way.periodic_along ? rows_of_reach(surface, way, tangents) : 0;
    const int lines =
        way.periodic_across
            ? way.across
            : way.across + static_cast<int>(std::ceil(std::abs(way.shift) * way.along)) + 3;
    pool_.for_ranges(lines, [&](int begin, int end) {
        for (int first = begin; first < end; first += lines_at_once)
            follow_lines(surface, way, tangents, find, first, std::min(first + lines_at_once, end));
    });
}

WindShadow::Way WindShadow::way_of(const BlowingWind& wind) const {
    const double cells_x = wind.x / ground_.dx;
    const double cells_y = wind.y / ground_.dy;
    const bool turned = std::abs(cells_x) > std::abs(cells_y);
    Way way;
    way.turned = turned;
    way.across = turned ? ground_.ny : ground_.nx;
    way.along = turned ? ground_.nx : ground_.ny;
    way.periodic_across = turned ? ground_.periodic_y : ground_.periodic_x;
    way.periodic_along = turned ? ground_.periodic_x : ground_.periodic_y;
    const double along = turned ? cells_x : cells_y;
    const double across = turned ? cells_y : cells_x;
    way.forward = along > 0.0;
    way.shift = across / std::abs(along);
    way.distance = 1.0 / std::abs(along);
    return way;
}

int WindShadow::rows_of_reach(const WholeGrid& surface, const Way& way,
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
    const double soft_drop = tangents.soft * way.distance;
    return static_cast<int>(std::min<double>(std::ceil(relief / soft_drop) + 1.0, way.along));
}

void WindShadow::follow_lines(const WholeGrid& surface, const Way& way,
                              const ShadowTangents& tangents, Find find, int first, int last) {
    // Line l is at cell l + base + shift·n of row n; of those that come in from the sides base
    // makes room. One line more lies beside the first cell.
    const double base = way.periodic_across ? 0.0
                        : way.shift > 0.0   ? -std::ceil(way.shift * way.along) - 1.0
                                            : -1.0;
    const shadow_vectors::Fall fall{way.distance, tangents.soft * way.distance,
                                    tangents.full * way.distance};
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
    std::array<Stretch, rows_at_once> rows{};
    const bool with_envelope = find == Find::shade_and_envelope;
    for (int begin = -rows_before_; begin < way.along;) {
        give_up_if_asked();
        const int end = std::min(begin + rows_at_once, begin < 0 ? 0 : way.along);
        const std::span stretches(rows.data(), static_cast<std::size_t>(end - begin));
        for (int n = begin; n < end; ++n) {
            const double at = base + way.shift * n;
            const double cell = std::floor(at);
            const int going = ((n % way.along) + way.along) % way.along;
            rows[static_cast<std::size_t>(n - begin)] = {
                way.forward ? going : way.along - 1 - going,
                first - 1 + static_cast<std::int64_t>(cell), at - cell};
        }
        fetch(surface, way, stretches, count + 1, heights);
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            shadow_vectors::go_on(lines, fall, {heights[k].data(), stretches[k].beyond},
                                  tangents.full - tangents.soft,
                                  begin < 0 ? nullptr : heights[k].data(),
                                  with_envelope ? envelope[k].data() : nullptr);
        }
        if (begin >= 0) {
            for (Stretch& stretch : stretches) ++stretch.cell;
            give_back(heights, way, stretches, count - 1, shade_);
            if (with_envelope) give_back(envelope, way, stretches, count - 1, envelope_);
        }
        begin = end;
    }
}

}  // namespace fumon
