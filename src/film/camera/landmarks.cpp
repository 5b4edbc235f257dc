#include "film/camera/landmarks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "base/snapshot_lookup.h"
#include "measure/bed/dunes.h"
#include "measure/network/flow_routing.h"

namespace fumon {

namespace {

constexpr double side_share_of_breadth = 0.125;    // of what has no breadth of its own
constexpr double surroundings_share = 1.0 / 12.0;  // half the side of a channel's surroundings
constexpr double most_of_bed = 0.4;                // that a dune takes
constexpr double edge_share = 0.0625;              // kept from the edges

bool has_data(const Snapshot& bed, std::size_t cell) {
    return bed.nodata.empty() || bed.nodata.values()[cell] == 0;
}

double longer_side(const Snapshot& bed) {
    return static_cast<double>(std::max(bed.bed.nx(), bed.bed.ny()));
}

Landmark landmark_of_cell(const Snapshot& bed, std::size_t cell) {
    const auto nx = static_cast<std::size_t>(bed.bed.nx());
    const std::size_t row = cell / nx;
    return {static_cast<double>(cell % nx), static_cast<double>(row), bed.bed.values()[cell],
            side_share_of_breadth * longer_side(bed)};
}

/// The cell whose value is largest.
template <class Value>
std::size_t largest_cell(const Snapshot& bed, const Value& value) {
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < bed.bed.size(); ++cell) {
        if (!has_data(bed, cell)) continue;
        const double here = value(cell);
        if (here <= most) continue;
        most = here;
        best = cell;
    }
    return best;
}

/// How many cells above a height hang together with one.
std::size_t piece_above(const Snapshot& bed, std::size_t from, double level) {
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    std::vector<bool> seen(bed.bed.size());
    std::vector<std::size_t> open{from};
    seen[from] = true;
    std::size_t count = 0;
    while (!open.empty()) {
        const std::size_t cell = open.back();
        open.pop_back();
        ++count;
        const int x = static_cast<int>(cell) % nx;
        const int y = static_cast<int>(cell) / nx;
        const auto visit = [&](int i, int j) {
            if (bed.periodic) {
                i = (i + nx) % nx;
                j = (j + ny) % ny;
            }
            if (i < 0 || i >= nx || j < 0 || j >= ny) return;
            const std::size_t next = static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                                     static_cast<std::size_t>(i);
            if (seen[next] || !has_data(bed, next) || bed.bed.values()[next] < level) return;
            seen[next] = true;
            open.push_back(next);
        };
        visit(x - 1, y);
        visit(x + 1, y);
        visit(x, y - 1);
        visit(x, y + 1);
    }
    return count;
}

Landmark highest(const Snapshot& bed) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t cell = 0; cell < bed.bed.size(); ++cell) {
        if (!has_data(bed, cell)) continue;
        sum += bed.bed.values()[cell];
        count += 1.0;
    }
    const std::size_t top =
        largest_cell(bed, [&](std::size_t cell) { return bed.bed.values()[cell]; });
    Landmark found = landmark_of_cell(bed, top);
    found.height = 0.5 * (found.height + sum / std::max(1.0, count));
    const auto area = static_cast<double>(piece_above(bed, top, found.height));
    const double side = longer_side(bed);
    found.breadth = std::clamp(2.0 * std::sqrt(area), side_share_of_breadth * side, 0.9 * side);
    return found;
}

Landmark largest_dune(const Snapshot& bed) {
    std::vector<Dune> dunes = separate_dunes(bed.bed, bed.periodic).dunes;
    const double largest = most_of_bed * static_cast<double>(bed.bed.size());
    std::erase_if(dunes, [&](const Dune& dune) {
        return static_cast<double>(dune.area) > largest;  // a bed of sand all over
    });
    const auto most = std::ranges::max_element(dunes, {}, &Dune::volume);
    if (most == dunes.end()) return highest(bed);
    return {most->centre_x, most->centre_y, 0.5 * most->height,
            std::sqrt(static_cast<double>(most->area))};
}

/// Sums of a grid and counts of its cells with data, from its corner to each cell.
struct SumTable {
    explicit SumTable(const Snapshot& bed)
        : nx(bed.bed.nx()), ny(bed.bed.ny()), sums(nx + 1, ny + 1, 0.0), counts(sums) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const auto cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) +
                                  static_cast<std::size_t>(x);
                const bool there = has_data(bed, cell);
                const double height = there ? bed.bed(x, y) : 0.0;
                sums(x + 1, y + 1) = height + sums(x, y + 1) + sums(x + 1, y) - sums(x, y);
                counts(x + 1, y + 1) =
                    (there ? 1.0 : 0.0) + counts(x, y + 1) + counts(x + 1, y) - counts(x, y);
            }
        }
    }

    /// The mean over a square around a cell, as far as it lies on the bed.
    [[nodiscard]] double mean(int x, int y, int reach) const {
        const int west = std::max(0, x - reach);
        const int east = std::min(nx, x + reach + 1);
        const int south = std::max(0, y - reach);
        const int north = std::min(ny, y + reach + 1);
        const auto over = [&](const Grid& table) {
            return table(east, north) - table(west, north) - table(east, south) +
                   table(west, south);
        };
        return over(sums) / std::max(1.0, over(counts));
    }

    int nx;
    int ny;
    Grid sums;
    Grid counts;
};

Landmark deepest_channel(const Snapshot& bed) {
    const SumTable table(bed);
    const int nx = bed.bed.nx();
    const int reach =
        std::max(2, static_cast<int>(std::lround(surroundings_share * longer_side(bed))));
    const int margin = bed.periodic ? 0 : static_cast<int>(edge_share * std::min(nx, bed.bed.ny()));
    const std::size_t cell = largest_cell(bed, [&](std::size_t at) {
        const int x = static_cast<int>(at) % nx;
        const int y = static_cast<int>(at) / nx;
        const bool inside =
            x >= margin && x < nx - margin && y >= margin && y < bed.bed.ny() - margin;
        const double depth = table.mean(x, y, reach) - table.mean(x, y, 1);
        return inside ? depth : depth - 1e12;
    });
    return landmark_of_cell(bed, cell);
}

Landmark outlet(const Snapshot& bed) {
    const FlowRouting routing = route_flow(bed);
    const Grid areas = drainage_area(routing);
    return landmark_of_cell(bed, largest_cell(bed, [&](std::size_t cell) {
                                const bool leaves =
                                    routing.receiver.values()[cell] == FlowRouting::outlet;
                                return leaves ? areas.values()[cell] : 0.0;
                            }));
}

Landmark middle(const Snapshot& bed) {
    const double x = 0.5 * (bed.bed.nx() - 1);
    const double y = 0.5 * (bed.bed.ny() - 1);
    return {x, y, bed.bed(static_cast<int>(x), static_cast<int>(y)),
            0.25 * std::min(bed.bed.nx(), bed.bed.ny())};
}

/// The mean place of cells, each weighed by the fourth power of how its depth changes there.
Landmark flood_front(const Snapshot& bed) {
    const Grid* depth = field_of(bed.fields, "water_depth");
    if (depth == nullptr) return middle(bed);
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    const auto is_outside = [&](int x, int y) {
        return !bed.nodata.empty() && bed.nodata(x, y) != 0;
    };
    double sum = 0.0;
    double east = 0.0;
    double north = 0.0;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (is_outside(x, y)) continue;
            const auto beside = [&](int i, int j) {  // where the data end there is no front
                i = std::clamp(i, 0, nx - 1);
                j = std::clamp(j, 0, ny - 1);
                return is_outside(i, j) ? (*depth)(x, y) : (*depth)(i, j);
            };
            const double along = beside(x + 1, y) - beside(x - 1, y);
            const double across = beside(x, y + 1) - beside(x, y - 1);
            const double steep = along * along + across * across;
            if (!(steep > 0.0)) continue;  // or the depth is not known there
            const double weight = steep * steep;
            sum += weight;
            east += weight * x;
            north += weight * y;
        }
    }
    if (!(sum > 0.0)) return middle(bed);
    const double x = east / sum;
    const double y = north / sum;
    return {x, y, bed.bed(static_cast<int>(x), static_cast<int>(y)),
            side_share_of_breadth * longer_side(bed)};
}

}  // namespace

Landmark find_landmark(const std::string& name, const Snapshot& bed) {
    if (name == "highest") return highest(bed);
    if (name == "largest dune") return largest_dune(bed);
    if (name == "deepest channel") return deepest_channel(bed);
    if (name == "outlet") return outlet(bed);
    if (name == "lowest") {
        return landmark_of_cell(
            bed, largest_cell(bed, [&](std::size_t cell) { return -bed.bed.values()[cell]; }));
    }
    if (name == "middle") return middle(bed);
    if (name == "flood front") return flood_front(bed);
    throw std::invalid_argument("no landmark: " + name);
}

LandmarkOnStage landmark_on_stage(const FilmStage& stage, const std::string& name,
                                  const Snapshot& bed) {
    const Landmark found = find_landmark(name, bed);
    const int nx = bed.bed.nx();
    const int ny = bed.bed.ny();
    const double ground = bed.bed(std::clamp(static_cast<int>(std::lround(found.x)), 0, nx - 1),
                                  std::clamp(static_cast<int>(std::lround(found.y)), 0, ny - 1));
    const Block& block = stage.block;
    return {place_on_stage(stage,
                           {(found.x + 0.5) / nx * block.width_x * block.side,
                            (found.y + 0.5) / ny * block.width_y * block.side,
                            (found.height - ground) * bed.scale.height_unit},
                           bed),
            found.breadth / nx * block.width_x};
}

}  // namespace fumon
