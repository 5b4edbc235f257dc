#include "files/terrain/resample_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "files/terrain/terrain_file.h"

namespace fumon {

namespace {

/// A cell that a new one is made from, and its share.
struct Part {
    int cell = 0;
    double weight = 0.0;
};

/// Along one side: the parts of every new cell, and the cell in which its centre lies.
struct Side {
    std::vector<std::vector<Part>> parts;
    std::vector<int> nearest;
};

std::vector<Part> average_parts(double low, double high, int cells) {
    std::vector<Part> parts;
    const int first = std::clamp(static_cast<int>(std::floor(low)), 0, cells - 1);
    for (int cell = first; cell < cells && cell < high; ++cell) {
        const double width = std::min(high, cell + 1.0) - std::max(low, static_cast<double>(cell));
        constexpr double rounding = 1e-9;  // cells
        if (width > rounding || parts.empty()) parts.push_back({cell, width});
    }
    return parts;
}

std::vector<Part> bilinear_parts(double centre, int cells) {
    const double place = centre - 0.5;
    const int below = static_cast<int>(std::floor(place));
    const double share = place - below;
    const int last = cells - 1;
    if (share == 0.0) return {{std::clamp(below, 0, last), 1.0}};
    return {{std::clamp(below, 0, last), 1.0 - share}, {std::clamp(below + 1, 0, last), share}};
}

/// `ratio`: cells of the file per new one.
Side side_of(int cells, int new_cells, double ratio, Resampling method) {
    Side side;
    for (int i = 0; i < new_cells; ++i) {
        const double centre = (i + 0.5) * ratio;
        const int nearest = std::clamp(static_cast<int>(std::floor(centre)), 0, cells - 1);
        side.nearest.push_back(nearest);
        switch (method) {
            case Resampling::average:
                side.parts.push_back(average_parts(i * ratio, (i + 1) * ratio, cells));
                break;
            case Resampling::bilinear:
                side.parts.push_back(bilinear_parts(centre, cells));
                break;
            case Resampling::nearest:
                side.parts.push_back({{nearest, 1.0}});
                break;
        }
    }
    return side;
}

double cells_along(int cells, double ratio) {
    constexpr double rounding = 1e-6;  // new cells
    return std::floor(cells / ratio + rounding);
}

}  // namespace

Terrain resampled(const Terrain& terrain, double dx, double dy, double size, Resampling method,
                  const std::string& what) {
    const double ratio_x = size / dx;
    const double ratio_y = size / dy;
    const Grid& old = terrain.heights;
    const double nx = cells_along(old.nx(), ratio_x);
    const double ny = cells_along(old.ny(), ratio_y);
    if (nx < 1.0 || ny < 1.0) {
        throw InputError(
            fmt::format("{} is {} m, more than the terrain's {:.6g} x {:.6g} m; take "
                        "smaller cells",
                        what, size, dx * old.nx(), dy * old.ny()));
    }
    if (nx * ny > static_cast<double>(largest_grid_cells)) {
        throw InputError(fmt::format("{} is {} m: {} x {} cells are too many, at most {}", what,
                                     size, nx, ny, largest_grid_cells));
    }
    const Side x_side = side_of(old.nx(), static_cast<int>(nx), ratio_x, method);
    const Side y_side = side_of(old.ny(), static_cast<int>(ny), ratio_y, method);

    Terrain made;
    made.note = terrain.note;
    made.place = terrain.place;
    if (made.place) {
        made.place->dx *= ratio_x;
        made.place->dy *= ratio_y;
    }
    made.dx = size;
    made.dy = size;
    made.heights = Grid(static_cast<int>(nx), static_cast<int>(ny));
    if (!terrain.nodata.empty()) made.nodata = Mask(made.heights.nx(), made.heights.ny());
    for (int y = 0; y < made.heights.ny(); ++y) {
        const auto row = static_cast<std::size_t>(y);
        for (int x = 0; x < made.heights.nx(); ++x) {
            const auto column = static_cast<std::size_t>(x);
            double sum = 0.0;
            double known = 0.0;
            double all = 0.0;
            for (const Part& v : y_side.parts[row]) {
                for (const Part& u : x_side.parts[column]) {
                    const double weight = u.weight * v.weight;
                    all += weight;
                    if (!terrain.nodata.empty() && terrain.nodata(u.cell, v.cell) != 0) continue;
                    known += weight;
                    sum += weight * old(u.cell, v.cell);
                }
            }
            const bool hole =
                !terrain.nodata.empty() &&
                (method == Resampling::average
                     ? known < 0.5 * all
                     : terrain.nodata(x_side.nearest[column], y_side.nearest[row]) != 0);
            if (hole) {
                made.nodata(x, y) = 1;
            } else {
                made.heights(x, y) = sum / known;
            }
        }
    }
    if (std::ranges::count(made.nodata.values(), 1) == 0) made.nodata = {};
    return made;
}

}  // namespace fumon
