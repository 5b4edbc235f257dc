#include "numerics/tension_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace fumon {

namespace {

constexpr double tension = 0.35;
constexpr int coarsest = 8;          // cells along the shorter side
constexpr int sweeps = 40;           // over few cells
constexpr int few = 256 * 256;       // cells
constexpr int sweeps_over_many = 6;  // everywhere, and `sweeps` near known cells
constexpr float near = 20.0F;        // cells

int halved(int count) {
    return (count + 1) / 2;
}

/// Whether none of 2 × 2 cells is known.
Mask coarser(const Mask& fine) {
    Mask coarse(halved(fine.nx()), halved(fine.ny()), 1);
    for (int y = 0; y < fine.ny(); ++y)
        for (int x = 0; x < fine.nx(); ++x)
            if (fine(x, y) == 0) coarse(x / 2, y / 2) = 0;
    return coarse;
}

/// Means of the known among 2 × 2 cells.
Grid coarser(const Grid& fine, const Mask& unknown) {
    const int nx = fine.nx();
    const int ny = fine.ny();
    Grid coarse(halved(nx), halved(ny));
    for (int y = 0; y < coarse.ny(); ++y) {
        for (int x = 0; x < coarse.nx(); ++x) {
            double sum = 0.0;
            int count = 0;
            for (int v = 2 * y; v < std::min(2 * y + 2, ny); ++v) {
                for (int u = 2 * x; u < std::min(2 * x + 2, nx); ++u) {
                    if (unknown(u, v) != 0) continue;
                    sum += fine(u, v);
                    ++count;
                }
            }
            if (count > 0) coarse(x, y) = sum / count;
        }
    }
    return coarse;
}

/// Gives the unknown cells of a field what the next coarser one has there.
void refine_into(Grid& fine, const Mask& unknown, const Grid& coarse) {
    struct Between {
        int first;
        int second;
        double share;
    };
    const auto between = [](int cell, int count) {
        const double place = (cell + 0.5) / 2.0 - 0.5;
        const int low = static_cast<int>(std::floor(place));
        return Between{(low + count) % count, (low + 1) % count, place - low};
    };
    for (int y = 0; y < fine.ny(); ++y) {
        const Between row = between(y, coarse.ny());
        for (int x = 0; x < fine.nx(); ++x) {
            if (unknown(x, y) == 0) continue;
            const Between column = between(x, coarse.nx());
            const auto along = [&](int j) {
                return std::lerp(coarse(column.first, j), coarse(column.second, j), column.share);
            };
            fine(x, y) = std::lerp(along(row.first), along(row.second), row.share);
        }
    }
}

/// Calls chosen(y, first, end) for cells side by side whose is(x, y) holds, row by row.
template <class Is, class Chosen>
void for_runs(int nx, int ny, const Is& is, const Chosen& chosen) {
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx;) {
            const int first = x;
            while (x < nx && is(x, y)) ++x;
            if (x > first) chosen(y, first, x);
            while (x < nx && !is(x, y)) ++x;
        }
    }
}

}  // namespace

/// Gauss–Seidel over the chosen cells, row by row, `count` times.
void TensionSurface::relax(Grid& f, const std::vector<Run>& chosen, int count) {
    const int nx = f.nx();
    const int ny = f.ny();
    const auto wrapped = [](int cell, int size) { return (cell % size + size) % size; };
    constexpr double side = 8.0 * (1.0 - tension) + tension;
    constexpr double corner = -2.0 * (1.0 - tension);
    constexpr double away = -(1.0 - tension);
    constexpr double own = 20.0 * (1.0 - tension) + 4.0 * tension;
    for (int sweep = 0; sweep < count; ++sweep) {
        for (const Run& run : chosen) {
            std::array<double*, 5> rows{};
            for (int k = 0; k < 5; ++k)
                rows.at(static_cast<std::size_t>(k)) = f.row(wrapped(run.y + k - 2, ny)).data();
            const auto& [s2, s1, here, n1, n2] = rows;
            for (int x = run.first; x < run.end; ++x) {
                const int w1 = x >= 1 ? x - 1 : wrapped(x - 1, nx);
                const int w2 = x >= 2 ? x - 2 : wrapped(x - 2, nx);
                const int e1 = x + 1 < nx ? x + 1 : wrapped(x + 1, nx);
                const int e2 = x + 2 < nx ? x + 2 : wrapped(x + 2, nx);
                here[x] = (side * (here[w1] + here[e1] + s1[x] + n1[x]) +
                           corner * (s1[w1] + s1[e1] + n1[w1] + n1[e1]) +
                           away * (here[w2] + here[e2] + s2[x] + n2[x])) /
                          own;
            }
        }
    }
}

void TensionSurface::relax_as_needed(Grid& field, const Level& level) {
    if (field.size() <= few) {
        relax(field, level.all, sweeps);
        return;
    }
    relax(field, level.all, sweeps_over_many);
    relax(field, level.seam, sweeps);
}

TensionSurface::Level TensionSurface::level_of(Mask unknown) {
    Level level;
    const auto into = [](std::vector<Run>& runs) {
        return [&runs](int y, int first, int end) { runs.push_back({y, first, end}); };
    };
    const auto is_unknown = [&](int x, int y) { return unknown(x, y) != 0; };
    for_runs(unknown.nx(), unknown.ny(), is_unknown, into(level.all));
    if (unknown.size() > few) {
        Mask known = unknown;
        for (std::uint8_t& cell : known.values()) cell = cell == 0 ? 1 : 0;
        const Field<float> distance = distances_to(known);
        const auto is_near = [&](int x, int y) {
            return unknown(x, y) != 0 && !(distance(x, y) > near);
        };
        for_runs(unknown.nx(), unknown.ny(), is_near, into(level.seam));
    }
    level.unknown = std::move(unknown);
    return level;
}

TensionSurface::TensionSurface(const Mask& unknown) {
    if (std::ranges::count(unknown.values(), std::uint8_t{0}) == 0) return;
    levels_.push_back(level_of(unknown));
    while (std::min(levels_.back().unknown.nx(), levels_.back().unknown.ny()) > coarsest)
        levels_.push_back(level_of(coarser(levels_.back().unknown)));
}

void TensionSurface::fill(Grid& field) const {
    if (levels_.empty()) return;
    std::vector<Grid> fields;
    fields.push_back(std::move(field));
    for (std::size_t i = 1; i < levels_.size(); ++i)
        fields.push_back(coarser(fields.back(), levels_[i - 1].unknown));
    Grid& last = fields.back();
    const Mask& unknown = levels_.back().unknown;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
        if (unknown.values()[i] != 0) continue;
        sum += last.values()[i];
        ++count;
    }
    for (std::size_t i = 0; i < last.size(); ++i)
        if (unknown.values()[i] != 0) last.values()[i] = sum / static_cast<double>(count);
    relax(last, levels_.back().all, sweeps);
    for (std::size_t i = levels_.size() - 1; i-- > 0;) {
        refine_into(fields[i], levels_[i].unknown, fields[i + 1]);
        relax_as_needed(fields[i], levels_[i]);
    }
    field = std::move(fields.front());
}

void fill_in_tension(Grid& field, const Mask& unknown) {
    TensionSurface(unknown).fill(field);
}

Field<float> distances_to(const Mask& goal) {
    constexpr float diagonal = 1.41421356F;
    const int nx = goal.nx();
    const int ny = goal.ny();
    Field<float> distance(nx, ny, 1e9F);
    for (std::size_t i = 0; i < goal.size(); ++i)
        if (goal.values()[i] != 0) distance.values()[i] = 0.0F;
    const auto wrapped = [](int cell, int size) { return (cell + size) % size; };
    const auto take = [&](int x, int y, int back) {
        const auto from = [&](int i, int j, float step) {
            return distance(wrapped(x + i, nx), wrapped(y + j, ny)) + step;
        };
        float& own = distance(x, y);
        own = std::min({own, from(-back, 0, 1.0F), from(0, -back, 1.0F),
                        from(-back, -back, diagonal), from(back, -back, diagonal)});
    };
    for (int round = 0; round < 2; ++round) {  // the second one over the edges
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) take(x, y, 1);
        for (int y = ny - 1; y >= 0; --y)
            for (int x = nx - 1; x >= 0; --x) take(x, y, -1);
    }
    return distance;
}

}  // namespace fumon
