#include "files/terrain/terraces/terraces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "files/terrain/terraces/bounded_plate.h"

namespace fumon {

namespace {

constexpr double foot = 0.3048;
constexpr double survey_foot = 1200.0 / 3937.0;
constexpr std::array<double, 8> parts{10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1};
constexpr int side_of_water = 17;             // cells
constexpr double higher_around_water = 0.95;  // share of neighbours

bool has_data(const Terrain& terrain, std::size_t cell) {
    return terrain.nodata.empty() || terrain.nodata.values()[cell] == 0;
}

/// Steps that may be, the largest first.
std::vector<double> candidates(const Terrain& terrain) {
    std::vector<double> steps;
    for (const double unit : {1.0, foot, survey_foot, std::abs(terrain.metres_per_number)}) {
        for (const double part : parts) steps.push_back(unit * part);
    }
    std::ranges::sort(steps, std::greater<>());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return steps;
}

/// A connected area of one height.
struct Level {
    std::vector<std::size_t> cells;
    std::size_t higher = 0;  ///< neighbours around it
    std::size_t around = 0;
};

/// Finds the level area of a cell, whose cells it marks in `seen`.
Level level_area(const Terrain& terrain, std::size_t from, Mask& seen) {
    const Grid& heights = terrain.heights;
    const auto nx = static_cast<std::size_t>(heights.nx());
    const double height = heights.values()[from];
    Level level;
    level.cells.push_back(from);
    seen.values()[from] = 1;
    for (std::size_t next = 0; next < level.cells.size(); ++next) {
        const std::size_t cell = level.cells[next];
        const std::size_t x = cell % nx;
        const auto visit = [&](bool inside, std::size_t neighbour) {
            if (!inside || !has_data(terrain, neighbour)) return;
            const double other = heights.values()[neighbour];
            if (other != height) {
                ++level.around;
                if (other > height) ++level.higher;
            } else if (seen.values()[neighbour] == 0) {
                seen.values()[neighbour] = 1;
                level.cells.push_back(neighbour);
            }
        };
        visit(x > 0, cell - 1);
        visit(x + 1 < nx, cell + 1);
        visit(cell >= nx, cell - nx);
        visit(cell + nx < heights.size(), cell + nx);
    }
    return level;
}

/// 1 for the cells of water, see without_terraces().
Mask level_water(const Terrain& terrain) {
    const Grid& heights = terrain.heights;
    const int nx = heights.nx();
    Mask water(nx, heights.ny());
    Mask seen(nx, heights.ny());
    // The side of the largest level square whose north-eastern corner a cell is.
    std::vector<int> below(static_cast<std::size_t>(nx));
    std::vector<int> sides(static_cast<std::size_t>(nx));
    for (int y = 0; y < heights.ny(); ++y) {
        for (int x = 0; x < nx; ++x) {
            const auto at = static_cast<std::size_t>(x);
            const auto cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + at;
            sides[at] = has_data(terrain, cell) ? 1 : 0;
            if (sides[at] == 0 || x == 0 || y == 0) continue;
            const double height = heights(x, y);
            if (heights(x - 1, y) == height && heights(x, y - 1) == height &&
                heights(x - 1, y - 1) == height)
                sides[at] = 1 + std::min({sides[at - 1], below[at], below[at - 1]});
            if (sides[at] < side_of_water || seen(x, y) != 0) continue;
            const Level level = level_area(terrain, cell, seen);
            const bool is_water = static_cast<double>(level.higher) >=
                                  higher_around_water * static_cast<double>(level.around);
            if (!is_water) continue;
            for (const std::size_t wet : level.cells) water.values()[wet] = 1;
        }
        std::swap(below, sides);
    }
    return water;
}

}  // namespace

std::optional<double> height_step(const Terrain& terrain) {
    constexpr double single = 0x1p-22;
    const auto heights = terrain.heights.values();
    std::size_t first = 0;
    while (first < heights.size() && !has_data(terrain, first)) ++first;
    if (first == heights.size()) return std::nullopt;
    bool differ = false;
    std::vector<double> steps = candidates(terrain);
    for (std::size_t cell = first; cell < heights.size() && !steps.empty(); ++cell) {
        if (!has_data(terrain, cell) || heights[cell] == heights[first]) continue;
        differ = true;
        const double rise = heights[cell] - heights[first];
        const double noise = single * std::max(std::abs(heights[cell]), std::abs(heights[first]));
        std::erase_if(steps, [&](double step) {
            const double rest = std::abs(rise - step * std::nearbyint(rise / step));
            return rest > noise || noise > step / 8.0;
        });
    }
    return differ && !steps.empty() ? std::optional(steps.front()) : std::nullopt;
}

bool has_terraces(const Terrain& terrain, double step) {
    constexpr int least_side = 32;
    constexpr double least_steps = 8.0;
    const Grid& heights = terrain.heights;
    if (heights.nx() < least_side || heights.ny() < least_side) return false;
    std::size_t pairs = 0;
    std::size_t level = 0;
    double lowest = 0.0;
    double highest = 0.0;
    bool any = false;
    for (int y = 0; y < heights.ny(); ++y) {
        for (int x = 0; x < heights.nx(); ++x) {
            if (!terrain.nodata.empty() && terrain.nodata(x, y) != 0) continue;
            lowest = any ? std::min(lowest, heights(x, y)) : heights(x, y);
            highest = any ? std::max(highest, heights(x, y)) : heights(x, y);
            any = true;
            if (x == 0 || (!terrain.nodata.empty() && terrain.nodata(x - 1, y) != 0)) continue;
            ++pairs;
            if (heights(x, y) == heights(x - 1, y)) ++level;
        }
    }
    return highest - lowest >= least_steps * step && 4 * level >= pairs;
}

Grid without_terraces(const Terrain& terrain, double step, double dx, double dy) {
    const Mask water = level_water(terrain);
    Grid freedom(terrain.heights.nx(), terrain.heights.ny(), 0.5 * step);
    for (std::size_t cell = 0; cell < freedom.size(); ++cell) {
        if (water.values()[cell] != 0 || !has_data(terrain, cell)) freedom.values()[cell] = 0.0;
    }
    return bounded_plate(terrain.heights, freedom, terrain.nodata, dx, dy);
}

}  // namespace fumon
