#include "render/land/drained_land.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "measure/network/flow_routing.h"
#include "measure/network/level_queue.h"

namespace fumon {

namespace {

constexpr int coarse_side = 288;           // cells of the longer side, about
constexpr int reorganisations = 2;         // on coarse cells
constexpr double fine_share = 0.3;         // of the noise, that fine valleys begin with
constexpr double least_fall_share = 1e-3;  // of a hillslope's steepness, from a cell to the next
constexpr int most_smoothings = 8;
constexpr double uneven = 0.35;     // logarithm: slopes of places with drained areas alike
constexpr double dome_share = 0.1;  // of a hillslope's steepness, towards the tile's middle

/// The lowest heights over the outlets that let each cell stand above one of its neighbours as the
/// area that drains through it asks for: by the cheapest way to an outlet (Dijkstra 1959), so that
/// ridges are where ways of the same cost meet, without a step between them. `noise` of root mean
/// square 1 makes slopes uneven.
Grid graded(const FlowRouting& routing, const SlopeByArea& slopes, const Grid& noise) {
    const Grid area = drainage_area(routing);
    const int nx = area.nx();
    const int ny = area.ny();
    const double across = elementary::hypot(routing.dx, routing.dy);
    Grid slope(nx, ny);
    Grid heights(nx, ny);
    constexpr double not_reached = 1e300;
    LevelQueue front;
    for (const std::int32_t cell : routing.upward) {
        const auto here = static_cast<std::size_t>(cell);
        slope.values()[here] =
            slopes.at(area.values()[here]) *
            elementary::exp(uneven * std::clamp(noise.values()[here], -2.0, 2.0));
        heights.values()[here] = not_reached;
        if (routing.receiver.values()[here] != FlowRouting::outlet) continue;
        const double height = std::min(routing.dx, routing.dy) * slope.values()[here];
        heights.values()[here] = height;
        front.push(height, cell);
    }
    while (!front.empty()) {
        const LevelQueue::Entry from = front.pop();
        if (from.level > heights.values()[static_cast<std::size_t>(from.cell)]) continue;
        const int x = from.cell % nx;
        const int y = from.cell / nx;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ny - 1); ++v) {
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, nx - 1); ++u) {
                const double length = u == x ? routing.dy : v == y ? routing.dx : across;
                const double over = from.level + length * slope(u, v);
                if (over >= heights(u, v)) continue;  // those without data stay at 0
                heights(u, v) = over;
                front.push(over, v * nx + u);
            }
        }
    }
    return heights;
}

/// With a root mean square of 1.
Grid normalised(Grid field) {
    double sum = 0.0;
    for (const double value : field.values()) sum += value * value;
    const double share = sum > 0.0 ? std::sqrt(static_cast<double>(field.size()) / sum) : 0.0;
    for (double& value : field.values()) value *= share;
    return field;
}

/// Between the four nearest cells of a periodic field.
double between(const Grid& field, double x, double y) {
    const auto within = [](int position, int count) {
        return ((position % count) + count) % count;
    };
    const double west = std::floor(x);
    const double south = std::floor(y);
    const int x0 = within(static_cast<int>(west), field.nx());
    const int y0 = within(static_cast<int>(south), field.ny());
    const int x1 = within(x0 + 1, field.nx());
    const int y1 = within(y0 + 1, field.ny());
    const double low = std::lerp(field(x0, y0), field(x1, y0), x - west);
    const double high = std::lerp(field(x0, y1), field(x1, y1), x - west);
    return std::lerp(low, high, y - south);
}

Grid means_of(const Grid& fine, int nx, int ny) {
    Grid coarse(nx, ny);
    for (int y = 0; y < ny; ++y) {
        const int from_y = y * fine.ny() / ny;
        const int to_y = std::max((y + 1) * fine.ny() / ny, from_y + 1);
        for (int x = 0; x < nx; ++x) {
            const int from_x = x * fine.nx() / nx;
            const int to_x = std::max((x + 1) * fine.nx() / nx, from_x + 1);
            double sum = 0.0;
            for (int v = from_y; v < to_y; ++v)
                for (int u = from_x; u < to_x; ++u) sum += fine(u, v);
            coarse(x, y) = sum / ((to_x - from_x) * (to_y - from_y));
        }
    }
    return coarse;
}

/// How far a river wanders aside of an edge, −1 … 1, at a share of the way along it.
double wandering(double share, double begin) {
    const double turn = 2.0 * std::numbers::pi;
    return 0.5 * elementary::sin(turn * (share + begin)) +
           0.3 * elementary::sin(turn * (2.0 * share + 1.7 * begin)) +
           0.2 * elementary::sin(turn * (5.0 * share + 2.9 * begin));
}

FlowRouting routing_over(const Grid& heights, const Field<LandCell>& cells, double dx, double dy) {
    Mask outlets(cells.nx(), cells.ny());
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells.values()[i] == LandCell::outlet) outlets.values()[i] = 1;
    return route_flow(heights, outlets, dx, dy);
}

/// Lowers free cells below those from which water comes; returns which ones.
Mask carve(Grid& heights, const Field<LandCell>& cells, const FlowRouting& routing,
           double least_fall) {
    Mask carved(heights.nx(), heights.ny());
    for (auto cell = routing.upward.rbegin(); cell != routing.upward.rend(); ++cell) {
        const auto here = static_cast<std::size_t>(*cell);
        const std::int32_t receiver = routing.receiver.values()[here];
        if (receiver == FlowRouting::outlet) continue;
        const auto next = static_cast<std::size_t>(receiver);
        if (cells.values()[next] != LandCell::free) continue;
        const double most = heights.values()[here] - least_fall;
        if (heights.values()[next] <= most) continue;
        heights.values()[next] = most;
        carved.values()[next] = 1;
    }
    return carved;
}

void fill(Grid& heights, const Field<LandCell>& cells, double dx, double dy, double least_fall) {
    const FlowRouting routing = routing_over(heights, cells, dx, dy);
    for (const std::int32_t cell : routing.upward) {
        const auto here = static_cast<std::size_t>(cell);
        const std::int32_t receiver = routing.receiver.values()[here];
        if (receiver == FlowRouting::outlet || cells.values()[here] != LandCell::free) continue;
        double& height = heights.values()[here];
        height =
            std::max(height, heights.values()[static_cast<std::size_t>(receiver)] + least_fall);
    }
}

/// (1 2 1)/4 along both axes; `still` cells stay, and so do edges.
void smooth(Grid& heights, const Mask& still) {
    const Grid before = heights;
    for (int y = 1; y + 1 < heights.ny(); ++y) {
        for (int x = 1; x + 1 < heights.nx(); ++x) {
            if (still(x, y) != 0) continue;
            const auto row = [&](int v) {
                return before(x - 1, v) + 2.0 * before(x, v) + before(x + 1, v);
            };
            heights(x, y) = (row(y - 1) + 2.0 * row(y) + row(y + 1)) / 16.0;
        }
    }
}

/// The lowest surface that falls from some cells no more steeply than `steepest`, by chamfer
/// distances.
Grid falling_from(const Grid& heights, const Mask& from, double dx, double dy, double steepest) {
    constexpr double below_all = -1e300;
    const int nx = heights.nx();
    const int ny = heights.ny();
    Grid falling = heights;
    for (std::size_t i = 0; i < from.size(); ++i)
        if (from.values()[i] == 0) falling.values()[i] = below_all;
    const double across = elementary::hypot(dx, dy);
    const auto take = [&](int x, int y, int u, int v, double length) {
        if (u < 0 || v < 0 || u >= nx || v >= ny) return;
        falling(x, y) = std::max(falling(x, y), falling(u, v) - steepest * length);
    };
    for (const int step : {-1, 1}) {  // once on the way there, once back
        for (int j = 0; j < ny; ++j) {
            const int y = step < 0 ? j : ny - 1 - j;
            for (int i = 0; i < nx; ++i) {
                const int x = step < 0 ? i : nx - 1 - i;
                take(x, y, x + step, y, dx);
                take(x, y, x - 1, y + step, across);
                take(x, y, x, y + step, dy);
                take(x, y, x + 1, y + step, across);
            }
        }
    }
    return falling;
}

/// Where cells are not free.
Mask staying(const Field<LandCell>& cells) {
    Mask stays(cells.nx(), cells.ny());
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells.values()[i] != LandCell::free) stays.values()[i] = 1;
    return stays;
}

/// Of cells that stay, those with a free one beside them.
Mask rims(const Field<LandCell>& cells) {
    const auto is_free = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < cells.nx() && y < cells.ny() &&
               cells(x, y) == LandCell::free;
    };
    Mask rim(cells.nx(), cells.ny());
    for (int y = 0; y < cells.ny(); ++y) {
        for (int x = 0; x < cells.nx(); ++x) {
            if (is_free(x, y)) continue;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u)
                    if (is_free(u, v)) rim(x, y) = 1;
        }
    }
    return rim;
}

}  // namespace

void drain(Grid& heights, const Field<LandCell>& cells, double dx, double dy, double least_fall) {
    carve(heights, cells, routing_over(heights, cells, dx, dy), least_fall);
    fill(heights, cells, dx, dy, least_fall);
}

void drain_between(Grid& heights, const Field<LandCell>& cells, double dx, double dy,
                   double least_fall, double steepest) {
    const Mask still = staying(cells);
    const Grid lowest = falling_from(heights, rims(cells), dx, dy, steepest);
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (still.values()[i] == 0)
            heights.values()[i] = std::max(heights.values()[i], lowest.values()[i]);
    drain_by_valleys(heights, cells, dx, dy, least_fall, steepest);
}

void drain_by_valleys(Grid& heights, const Field<LandCell>& cells, double dx, double dy,
                      double least_fall, double steepest) {
    Mask still = staying(cells);
    const Mask carved = carve(heights, cells, routing_over(heights, cells, dx, dy), least_fall);
    Grid floors = heights;
    for (double& height : floors.values()) height = -height;
    const Grid sides = falling_from(floors, carved, dx, dy, steepest);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double most = -sides.values()[i];
        if (still.values()[i] != 0) continue;
        if (heights.values()[i] < most) still.values()[i] = 1;
        heights.values()[i] = std::min(heights.values()[i], most);
    }
    smooth(heights, still);
    drain(heights, cells, dx, dy, least_fall);
}

DrainedTile drained_tile(const Grid& relief, const SlopeByArea& slopes, const LandRelief& wanted,
                         double dx, double dy, double wander) {
    const auto [gradient, roughness] = wanted;
    Grid noise = relief;
    const double own = mean_gradient(noise, {}, dx, dy);
    for (double& height : noise.values()) height *= own > 0.0 ? gradient / own : 0.0;
    const int longer = std::max(noise.nx(), noise.ny());
    const int coarsening = std::max(1, (longer + coarse_side - 1) / coarse_side);
    const int nx = std::max(noise.nx() / coarsening, 2);
    const int ny = std::max(noise.ny() / coarsening, 2);
    const double wide_x = dx * noise.nx() / nx;
    const double wide_y = dy * noise.ny() / ny;
    const Grid broad = means_of(noise, nx, ny);
    const auto at_edge = [&](int x, int y) {
        return x == 0 || y == 0 || x == nx - 1 || y == ny - 1;
    };
    Grid land(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double inward =
                std::min(wide_x * std::min(x, nx - 1 - x), wide_y * std::min(y, ny - 1 - y));
            land(x, y) = broad(x, y) + dome_share * slopes.hillslope() * inward;
        }
    }
    const double floor = *std::ranges::min_element(land.values()) - 1.0;
    for (int time = 0; time < reorganisations; ++time) {
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                if (at_edge(x, y)) land(x, y) = floor;
        land = graded(route_flow(land, {}, wide_x, wide_y), slopes, normalised(broad));
    }

    const double rate_x = static_cast<double>(nx) / noise.nx();
    const double rate_y = static_cast<double>(ny) / noise.ny();
    const auto beside_edge = [](double at, int count) {
        const double share = at / count;
        return count * std::abs(share - std::floor(share + 0.5));
    };
    // Of a tile's cell, or of one beside the tile: its place within the winding edges.
    struct EdgePosition {
        double u;
        double v;
    };
    const auto place_of = [&](int x, int y) {
        return EdgePosition{x + 0.5 + wander * wandering((y + 0.5) / noise.ny(), 0.13),
                            y + 0.5 + wander * wandering((x + 0.5) / noise.nx(), 0.61)};
    };
    const auto is_river = [&](const EdgePosition& at) {
        return beside_edge(at.u, noise.nx()) < 1.0 || beside_edge(at.v, noise.ny()) < 1.0;
    };
    const int margin = static_cast<int>(std::ceil(wander)) + 2;
    const auto within = [](int position, int count) {
        return ((position % count) + count) % count;
    };
    Grid wide(noise.nx() + 2 * margin, noise.ny() + 2 * margin);
    Mask beyond(wide.nx(), wide.ny(), 1);
    Grid uneven_slopes(wide.nx(), wide.ny());
    const Grid shares = normalised(noise);
    for (int y = 0; y < wide.ny(); ++y) {
        for (int x = 0; x < wide.nx(); ++x) {
            const EdgePosition at = place_of(x - margin, y - margin);
            if (at.u < 0.0 || at.v < 0.0 || at.u >= noise.nx() || at.v >= noise.ny() ||
                is_river(at))
                continue;
            beyond(x, y) = 0;
            const int u = within(x - margin, noise.nx());
            const int v = within(y - margin, noise.ny());
            wide(x, y) =
                between(land, rate_x * at.u - 0.5, rate_y * at.v - 0.5) + fine_share * noise(u, v);
            uneven_slopes(x, y) = shares(u, v);
        }
    }
    wide = graded(route_flow(wide, beyond, dx, dy), slopes, uneven_slopes);
    for (int pass = 0; pass < most_smoothings; ++pass) {
        const double bends = mean_bend(wide, beyond, dx, dy);
        if (bends <= roughness * mean_gradient(wide, beyond, dx, dy)) break;
        smooth(wide, beyond);
    }
    Field<LandCell> cells(wide.nx(), wide.ny(), LandCell::free);
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (beyond.values()[i] != 0) cells.values()[i] = LandCell::outlet;
    fill(wide, cells, dx, dy, least_fall_share * slopes.hillslope() * std::min(dx, dy));
    const double steep = mean_gradient(wide, beyond, dx, dy);
    const double scale = steep > 0.0 ? gradient / steep : 0.0;

    DrainedTile tile{Grid(noise.nx(), noise.ny()), Mask(noise.nx(), noise.ny())};
    for (int y = 0; y < noise.ny(); ++y) {
        for (int x = 0; x < noise.nx(); ++x) {
            const EdgePosition at = place_of(x, y);
            if (is_river(at)) {
                tile.rivers(x, y) = 1;
                continue;
            }
            const int from_x = x - noise.nx() * static_cast<int>(std::floor(at.u / noise.nx()));
            const int from_y = y - noise.ny() * static_cast<int>(std::floor(at.v / noise.ny()));
            tile.heights(x, y) = scale * wide(std::clamp(from_x + margin, 0, wide.nx() - 1),
                                              std::clamp(from_y + margin, 0, wide.ny() - 1));
        }
    }
    return tile;
}

}  // namespace fumon
