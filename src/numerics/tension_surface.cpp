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

struct Level {
    Grid field;
    Mask unknown;
};

int halved(int count) {
    return (count + 1) / 2;
}

/// Means of the known among 2 × 2 cells.
Level coarser(const Level& fine) {
    const int nx = fine.field.nx();
    const int ny = fine.field.ny();
    Level coarse{Grid(halved(nx), halved(ny)), Mask(halved(nx), halved(ny), 1)};
    for (int y = 0; y < coarse.field.ny(); ++y) {
        for (int x = 0; x < coarse.field.nx(); ++x) {
            double sum = 0.0;
            int count = 0;
            for (int v = 2 * y; v < std::min(2 * y + 2, ny); ++v) {
                for (int u = 2 * x; u < std::min(2 * x + 2, nx); ++u) {
                    if (fine.unknown(u, v) != 0) continue;
                    sum += fine.field(u, v);
                    ++count;
                }
            }
            if (count == 0) continue;
            coarse.field(x, y) = sum / count;
            coarse.unknown(x, y) = 0;
        }
    }
    return coarse;
}

/// Gives the unknown cells of a level what the next coarser one has there.
void refine_into(Level& fine, const Grid& coarse) {
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
    for (int y = 0; y < fine.field.ny(); ++y) {
        const Between row = between(y, coarse.ny());
        for (int x = 0; x < fine.field.nx(); ++x) {
            if (fine.unknown(x, y) == 0) continue;
            const Between column = between(x, coarse.nx());
            const auto along = [&](int j) {
                return std::lerp(coarse(column.first, j), coarse(column.second, j), column.share);
            };
            fine.field(x, y) = std::lerp(along(row.first), along(row.second), row.share);
        }
    }
}

/// Gauss–Seidel over the unknown cells, row by row, `count` times; `chosen`: only where that is
/// not 0.
void relax(Level& level, const Mask& chosen, int count) {
    Grid& f = level.field;
    const int nx = f.nx();
    const int ny = f.ny();
    const auto wrapped = [](int cell, int size) { return (cell % size + size) % size; };
    constexpr double side = 8.0 * (1.0 - tension) + tension;
    constexpr double corner = -2.0 * (1.0 - tension);
    constexpr double away = -(1.0 - tension);
    constexpr double own = 20.0 * (1.0 - tension) + 4.0 * tension;
    for (int sweep = 0; sweep < count; ++sweep) {
        for (int y = 0; y < ny; ++y) {
            std::array<double*, 5> rows{};
            for (int k = 0; k < 5; ++k)
                rows.at(static_cast<std::size_t>(k)) = f.row(wrapped(y + k - 2, ny)).data();
            const auto& [s2, s1, here, n1, n2] = rows;
            for (int x = 0; x < nx; ++x) {
                if (chosen(x, y) == 0) continue;
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

void relax_as_needed(Level& level) {
    if (level.field.size() <= few) {
        relax(level, level.unknown, sweeps);
        return;
    }
    relax(level, level.unknown, sweeps_over_many);
    Mask known = level.unknown;
    for (std::uint8_t& cell : known.values()) cell = cell == 0 ? 1 : 0;
    const Field<float> distance = distances_to(known);
    Mask seam = level.unknown;
    for (std::size_t i = 0; i < seam.size(); ++i)
        if (distance.values()[i] > near) seam.values()[i] = 0;
    relax(level, seam, sweeps);
}

}  // namespace

void fill_in_tension(Grid& field, const Mask& unknown) {
    if (std::ranges::count(unknown.values(), std::uint8_t{0}) == 0) return;
    std::vector<Level> levels;
    levels.push_back({std::move(field), unknown});
    while (std::min(levels.back().field.nx(), levels.back().field.ny()) > coarsest)
        levels.push_back(coarser(levels.back()));
    Level& last = levels.back();
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < last.field.size(); ++i) {
        if (last.unknown.values()[i] != 0) continue;
        sum += last.field.values()[i];
        ++count;
    }
    for (std::size_t i = 0; i < last.field.size(); ++i)
        if (last.unknown.values()[i] != 0)
            last.field.values()[i] = sum / static_cast<double>(count);
    relax(last, last.unknown, sweeps);
    for (std::size_t i = levels.size() - 1; i-- > 0;) {
        refine_into(levels[i], levels[i + 1].field);
        relax_as_needed(levels[i]);
    }
    field = std::move(levels.front().field);
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
