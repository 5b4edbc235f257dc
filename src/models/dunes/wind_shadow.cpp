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

/// Calls visit(k, i, row, cell) for the cell i of each stretch k, in the order in which they lie in
/// memory, that of columns where the stretches are `turned`. `cell` goes on with the other side of
/// a row that is `periodic`, else past its ends. Where they are turned it calls coming(row, cell)
/// for cells that it comes to soon, one of each line of the caches.
template <class Way, class Visit, class Coming>
void for_each_cell(const Way& way, std::span<const Stretch> stretches, int count,
                   const Visit& visit, const Coming& coming) {
    std::array<std::int64_t, rows_at_once> cells{};
    const std::int64_t size = way.across;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        const std::int64_t cell = stretches[k].cell;
        cells[k] = way.periodic_across ? (cell % size + size) % size : cell;
    }
    const std::int64_t end = way.periodic_across ? size : std::numeric_limits<std::int64_t>::max();
    const auto one = [&](std::size_t k, std::size_t i) {
        visit(k, i, stretches[k].row, cells[k]);
        if (++cells[k] == end) cells[k] = 0;
    };
    const auto size_of = static_cast<std::size_t>(count);
    if (way.turned) {
        constexpr std::int64_t soon = 4;
        constexpr std::size_t cells_of_line = 8;
        for (std::size_t i = 0; i < size_of; ++i) {
            for (std::size_t k = 0; k < stretches.size(); k += cells_of_line)
                coming(stretches[k].row, cells[k] + soon);
            for (std::size_t k = 0; k < stretches.size(); ++k) one(k, i);
        }
    } else {
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            for (std::size_t i = 0; i < size_of; ++i) one(k, i);
        }
    }
}

/// The ground under lines, metres; past an open edge that of the last cell.
template <class Way, class Heights>
void fetch(const WholeGrid& surface, const Way& way, std::span<const Stretch> stretches, int count,
           Heights& heights) {
    const auto within = [&](std::int64_t cell) {
        return static_cast<int>(std::clamp<std::int64_t>(cell, 0, way.across - 1));
    };
    const auto from = [&](const auto& height_at) {
        for_each_cell(
            way, stretches, count,
            [&](std::size_t k, std::size_t i, int row, std::int64_t cell) {
                heights[k][i] = to_metres(height_at(row, within(cell)));
            },
            [&](int row, std::int64_t cell) { __builtin_prefetch(&height_at(row, within(cell))); });
    };
    if (way.turned) {
        from([&](int row, int cell) -> const std::int64_t& { return surface(row, cell); });
    } else {
        from([&](int row, int cell) -> const std::int64_t& { return surface(cell, row); });
    }
}

/// Puts what was found between lines into their cells.
template <class Way, class Found>
void give_back(const Found& found, const Way& way, std::span<const Stretch> stretches, int count,
               Grid& grid) {
    const auto to = [&](const auto& value_at) {
        for_each_cell(
            way, stretches, count,
            [&](std::size_t k, std::size_t i, int row, std::int64_t cell) {
                if (cell < 0 || cell >= way.across) return;
                value_at(row, static_cast<int>(cell)) = found[k][i];
            },
            [&](int row, std::int64_t cell) {
                if (cell < 0 || cell >= way.across) return;
                __builtin_prefetch(&value_at(row, static_cast<int>(cell)), 1);
            });
    };
    if (way.turned) {
        to([&](int row, int cell) -> double& { return grid(row, cell); });
    } else {
        to([&](int row, int cell) -> double& { return grid(cell, row); });
    }
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
    shadow_vectors::Lines whole_vectors = lines;
    whole_vectors.count = (count + widest_vector - 1) / widest_vector * widest_vector;
    std::array<OfLines, rows_at_once> heights{};
    std::array<OfLines, rows_at_once> shade{};
    std::array<OfLines, rows_at_once> envelope{};
    std::array<Stretch, rows_at_once> rows{};
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
            const shadow_vectors::Between between{heights[k].data(), stretches[k].beyond};
            shadow_vectors::fall(whole_vectors, fall);
            if (begin >= 0) {
                shadow_vectors::shade(lines, between, tangents.full - tangents.soft,
                                      shade[k].data(), envelope[k].data());
            }
            shadow_vectors::lift(whole_vectors, between);
        }
        if (begin >= 0) {
            for (Stretch& stretch : stretches) ++stretch.cell;
            give_back(shade, way, stretches, count - 1, shade_);
            if (find == Find::shade_and_envelope)
                give_back(envelope, way, stretches, count - 1, envelope_);
        }
        begin = end;
    }
}

}  // namespace fumon
