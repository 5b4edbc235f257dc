// Drained land around a surveyed bed, and the water that runs out into it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/elementary_angle.h"
#include "base/snapshot_lookup.h"
#include "measure/network/flow_routing.h"
#include "numerics/smooth_step.h"
#include "numerics/tension_surface.h"
#include "render/land/drained_land.h"
#include "render/land/sea_level.h"
#include "render/view/surrounding_plain.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double wander_share = 0.35;      // of the margin: how far aside rivers wander
constexpr double low_share = 0.25;         // of the frame's cells, below the bed's lowest edge
constexpr double least_fall_share = 1e-3;  // of the mean gradient, from a cell to the next
constexpr double steepest_share = 1.5;     // of hillslopes: beside valleys that lead out
constexpr double clear_share = 0.8;        // of the margin: between the bed and the plain alone
constexpr int coarse_cell = 8;             // cells: over which slopes at the bed's edge are led on
constexpr double begins_within = 10.0;     // cells from the bed
constexpr double ends_within = 4.0;        // cells: water that no valley takes
constexpr double coast_begins_within = 6.0;
constexpr double coast_ends_within = 0.5;  // of the margin: the edge's slopes
constexpr int known_at_end = 3;            // cells of the tile
constexpr double bays = 0.25;              // of the margin
constexpr double least_land = 0.05;        // of the highest edge: what leads from land far along it
constexpr double least_stream = 3.0;       // of closed_depth: of streams and lakes
constexpr double rim_share = 0.125;        // of the bed's shorter side
constexpr double gentler_rim = 0.85;  // of the bed's mean gradient: land around it is gentler, too

/// Of the cells that lie within so many of the edge; `depth`: how many each lies within.
double rim_gradient(const Grid& heights, const Field<float>& depth, double cells, double dx,
                    double dy) {
    Mask others(heights.nx(), heights.ny());
    for (std::size_t i = 0; i < others.size(); ++i) {
        const auto within = static_cast<double>(depth.values()[i]);
        others.values()[i] = within > 0.0 && within <= cells ? 0 : 1;
    }
    return mean_gradient(heights, others, dx, dy);
}

}  // namespace

void SurroundingPlain::make_land(const Snapshot& first, const Mask& outside) {
    const double dx = first.scale.dx;
    const double dy = first.scale.dy;
    LandRelief relief = relief_of(first.bed, first.nodata, dx, dy);
    if (!(relief.gradient > 0.0)) return;
    const Grid heights = in_tile(first.bed);
    const Field<float> depth = distances_to(outside);
    Grid surface = heights;
    if (has_water(first)) {
        const Grid water = in_tile(*field_of(first.fields, "water_depth"));
        for (std::size_t i = 0; i < surface.size(); ++i)
            surface.values()[i] += water.values()[i] / first.scale.height_unit;
    }
    sea_ = sea_level(surface, depth,
                     has_water(first) ? closed_depth(first.scale) / first.scale.height_unit : 0.0);
    if (sea_) {
        make_coast(first, outside, *sea_);
        return;
    }
    // A lone mountain's foot goes on as a foot does.
    const double rim = rim_gradient(heights, depth, rim_share * std::min(bed_nx_, bed_ny_), dx, dy);
    if (rim > 0.0) relief.gradient = std::min(relief.gradient, rim / gentler_rim);
    const double gradient = relief.gradient;
    const SlopeByArea slopes(first.bed, first.nodata, dx, dy);
    const int margin = std::min(west_, south_);
    DrainedTile tile = drained_tile(relief_, slopes, relief, dx, dy, wander_share * margin);
    const Mask between = between_bed_and_plain(outside);

    double lowest = 1e300;
    double highest = -1e300;
    std::vector<double> frame;
    for (std::size_t i = 0; i < outside.size(); ++i) {
        if (outside.values()[i] == 0) {
            if (depth.values()[i] > 1.5F) continue;
            lowest = std::min(lowest, heights.values()[i]);
            highest = std::max(highest, heights.values()[i]);
        } else if (between.values()[i] == 0) {
            frame.push_back(tile.heights.values()[i]);
        }
    }
    if (frame.empty() || lowest > 1e299) return;
    const auto low =
        frame.begin() + static_cast<std::ptrdiff_t>(low_share * static_cast<double>(frame.size()));
    std::nth_element(frame.begin(), low, frame.end());
    const double outlet = *low;
    const double least_fall = least_fall_share * gradient * std::min(dx, dy);
    level_ = lowest - outlet - 4.0 * least_fall * (nx_ + ny_);
    relief_ = std::move(tile.heights);

    // Beside the bed its own relief goes on; ridges and valleys that others begin with come later.
    Grid under = broad(relief_);
    const Field<float>& away = surroundings_->away;
    for (std::size_t i = 0; i < under.size(); ++i) {
        const auto far = static_cast<double>(away.values()[i]);
        under.values()[i] =
            std::lerp(under.values()[i], relief_.values()[i], smooth_step(1.0, begins_within, far));
    }
    Field<LandCell> cells(nx_, ny_, LandCell::free);
    Grid missing(nx_, ny_);
    for (std::size_t i = 0; i < outside.size(); ++i) {
        if (outside.values()[i] == 0) {
            cells.values()[i] = LandCell::known;
            missing.values()[i] = heights.values()[i] - level_ - under.values()[i];
        } else if (between.values()[i] == 0) {
            cells.values()[i] = LandCell::known;
        }
    }
    lead_over(missing, between);
    own_ = Grid(nx_, ny_);
    for (std::size_t i = 0; i < own_.size(); ++i)
        own_.values()[i] = outside.values()[i] == 0
                               ? heights.values()[i]
                               : level_ + under.values()[i] + missing.values()[i];
    // From the highest rim down to the plain on the way there is.
    const double way = clear_share * margin * std::min(dx, dy);
    const double needed = (highest - level_ - *std::ranges::min_element(frame)) / way;
    drain_between(own_, cells, dx, dy, least_fall,
                  std::max(steepest_share * slopes.hillslope(), needed));
    downstream_ = route_flow(own_, {}, dx, dy).receiver;
}

/// Land goes on beyond the edge with ridges and valleys, and falls to the sea before the tile ends.
void SurroundingPlain::make_coast(const Snapshot& first, const Mask& outside, double sea) {
    const double dx = first.scale.dx;
    const double dy = first.scale.dy;
    const LandRelief wanted = relief_of(first.bed, first.nodata, dx, dy);
    const SlopeByArea slopes(first.bed, first.nodata, dx, dy);
    const int margin = std::min(west_, south_);
    const DrainedTile tile = drained_tile(relief_, slopes, wanted, dx, dy, wander_share * margin);
    const Mask between = within_of_bed(outside, coast_ends_within);
    const Grid heights = in_tile(first.bed);
    const Field<float> within = distances_to(outside);
    Mask inside(nx_, ny_);
    double deep = 0.0;
    std::size_t edge = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        inside.values()[i] = outside.values()[i] == 0 ? 1 : 0;
        if (inside.values()[i] == 0 || within.values()[i] > 1.5F || heights.values()[i] > sea)
            continue;
        deep += sea - heights.values()[i];
        ++edge;
    }
    if (edge > 0) deep /= static_cast<double>(edge);
    const double least_fall = least_fall_share * wanted.gradient * std::min(dx, dy);
    level_ = sea - deep - 4.0 * least_fall * (nx_ + ny_);

    Field<LandCell> cells(nx_, ny_, LandCell::free);
    Grid over(nx_, ny_);  // level_
    double highest = 0.0;
    double hills = 0.0;
    for (std::size_t i = 0; i < over.size(); ++i) {
        hills += tile.heights.values()[i] / static_cast<double>(over.size());
        if (inside.values()[i] == 0) continue;
        cells.values()[i] = LandCell::known;
        over.values()[i] = heights.values()[i] - level_;
        if (within.values()[i] <= 1.5F) highest = std::max(highest, over.values()[i]);
    }
    // Land goes on as high as the edge beside it, until it has to fall to the sea before the tile's
    // end; bays lie where rivers do.
    Grid standing = heights;
    for (double& height : standing.values()) height = std::max(height - sea, 0.0);
    standing = mean_of_edge(standing, within);
    const double least = least_land * highest;
    const Grid ridges = broad(tile.heights);
    const double fall = wanted.gradient * std::min(dx, dy);
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const int from_end = std::min({x, nx_ - 1 - x, y, ny_ - 1 - y});
            if (from_end < known_at_end) cells(x, y) = LandCell::known;
            if (between(x, y) != 0 || inside(x, y) != 0) continue;
            const double low = 1.0 - std::min(0.5 * ridges(x, y) / std::max(hills, 1e-9), 1.0);
            const double before_end = std::max(from_end - known_at_end - bays * margin * low, 0.0);
            const double land = std::max(standing(x, y) - least, 0.0);
            const double from_floor = land > 0.0 ? (sea - level_) * land / (land + least) : 0.0;
            over(x, y) = std::min(land + from_floor, fall * before_end);
        }
    }
    lead_over(over, between);
    const Field<float>& away = surroundings_->away;
    // Hills lie about the edge's height and begin as gently as they are: else they would stand
    // along it as a wall.
    const double begins = std::max(coast_begins_within, 2.0 * hills / fall);
    own_ = heights;
    for (std::size_t i = 0; i < own_.size(); ++i) {
        if (inside.values()[i] != 0) continue;
        const double stands = level_ + over.values()[i] - sea;
        const double begun = smooth_step(0.0, begins, static_cast<double>(away.values()[i]));
        const double inland = smooth_step(0.0, std::max(hills, 1e-9), stands);
        own_.values()[i] =
            level_ + over.values()[i] + begun * inland * (tile.heights.values()[i] - hills);
    }
    const double way = clear_share * margin * std::min(dx, dy);
    drain_between(own_, cells, dx, dy, least_fall,
                  std::max(steepest_share * slopes.hillslope(), highest / way));
    level_ = sea - deep;
    std::ranges::fill(relief_.values(), 0.0);
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (inside.values()[i] == 0) own_.values()[i] = std::max(own_.values()[i], level_);
    downstream_ = route_flow(own_, {}, dx, dy).receiver;
}

void SurroundingPlain::lead_over(Grid& tile, const Mask& between) const {
    const int nx = std::max(nx_ / coarse_cell, 4);
    const int ny = std::max(ny_ / coarse_cell, 4);
    struct Means {
        double sum = 0.0;
        int known = 0;
        int between = 0;
    };
    std::vector<Means> means(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const auto at = static_cast<std::size_t>(y * ny / ny_) * static_cast<std::size_t>(nx) +
                            static_cast<std::size_t>(x * nx / nx_);
            if (between(x, y) != 0) {
                ++means[at].between;
            } else {
                ++means[at].known;
                means[at].sum += tile(x, y);
            }
        }
    }
    Grid coarse(nx, ny);
    Mask unknown(nx, ny);
    for (std::size_t i = 0; i < means.size(); ++i) {
        unknown.values()[i] = means[i].between > means[i].known ? 1 : 0;
        if (means[i].known > 0) coarse.values()[i] = means[i].sum / means[i].known;
    }
    fill_in_tension(coarse, unknown);
    Grid led(nx_, ny_);
    for (int y = 0; y < ny_; ++y) {
        const double v = (y + 0.5) * ny / ny_ - 0.5 + ny;
        const int low = static_cast<int>(v);
        for (int x = 0; x < nx_; ++x) {
            const double u = (x + 0.5) * nx / nx_ - 0.5 + nx;
            const int left = static_cast<int>(u);
            const auto row = [&](int at) {
                return std::lerp(coarse(left % nx, at % ny), coarse((left + 1) % nx, at % ny),
                                 u - left);
            };
            led(x, y) = std::lerp(row(low), row(low + 1), v - low);
        }
    }
    led = broad(led);
    for (std::size_t i = 0; i < tile.size(); ++i) tile.values()[i] -= led.values()[i];
    fill_in_tension(tile, between);
    for (std::size_t i = 0; i < tile.size(); ++i) tile.values()[i] += led.values()[i];
}

/// Water that leaves the bed runs on as deep as it leaves, along the way down. All other ground is
/// as damp as the bed's edge is on average where no stream or lake lies, and deeper water at the
/// edge gives way to that within a few cells; by a sea at once.
void SurroundingPlain::add_water(const Snapshot& snapshot, const Surroundings& all,
                                 Snapshot& maps) const {
    const auto inside = [&](std::size_t cell) { return all.outside.values()[cell] == 0; };
    const Grid depth = in_tile(*field_of(snapshot.fields, "water_depth"));
    const Grid along_x = in_tile(*field_of(snapshot.fields, "velocity_x"));
    const Grid along_y = in_tile(*field_of(snapshot.fields, "velocity_y"));
    Grid stream(nx_, ny_);
    Grid speed(nx_, ny_);
    const double closed = closed_depth(snapshot.scale);
    double damp = 0.0;  // as the dampness of ground goes with the depth: by its root
    std::size_t edge = 0;
    for (std::size_t i = 0; i < stream.size(); ++i) {
        if (!inside(i)) continue;
        const double deep = std::max(depth.values()[i], 0.0);
        if (deep < least_stream * closed) {
            if (all.edge.values()[i] < 2) continue;
            damp += std::sqrt(std::min(deep / closed, 1.0));
            ++edge;
            continue;
        }
        const double fast = elementary::hypot(along_x.values()[i], along_y.values()[i]);
        for (std::int32_t cell = downstream_.values()[i]; cell != FlowRouting::outlet;
             cell = downstream_.values()[static_cast<std::size_t>(cell)]) {
            const auto at = static_cast<std::size_t>(cell);
            if (inside(at) || stream.values()[at] >= deep) break;
            stream.values()[at] = deep;
            speed.values()[at] = fast;
        }
    }
    if (edge > 0) damp /= static_cast<double>(edge);
    const double film = closed * damp * damp;
    const auto set = [&](const char* name, double far, const auto& value) {
        for (SnapshotField& field : maps.fields) {
            if (field.name != name) continue;
            for (int y = 0; y < ny_; ++y) {
                for (int x = 0; x < nx_; ++x) {
                    field.values(nx_ + x, y) = far;
                    if (all.outside(x, y) != 0)
                        field.values(x, y) = value(x, y, field.values(x, y));
                }
            }
        }
    };
    const auto share = [&](int x, int y) {
        return smooth_step(-ends_within, -0.5, -static_cast<double>(all.away(x, y)));
    };
    const double unit = snapshot.scale.height_unit;
    const double far_depth = sea_ ? std::max((*sea_ - level_) * unit, film) : film;
    set("water_depth", far_depth, [&](int x, int y, double continued) {
        const double sea = sea_ ? (*sea_ - maps.bed(x, y)) * unit : 0.0;
        if (sea > film) return sea;
        const double beside = sea_ ? film : std::max(continued, 0.0);  // the sea wets no land
        return std::max(stream(x, y), std::lerp(film, beside, share(x, y)));
    });
    const auto way = [&](int x, int y, bool east) {
        const std::int32_t next = downstream_(x, y);
        if (next == FlowRouting::outlet) return 0.0;
        const int next_x = next % nx_;
        const int next_y = next / nx_;
        const double u = next_x - x;
        const double v = next_y - y;
        return (east ? u : v) / elementary::hypot(u, v);
    };
    set("velocity_x", 0.0, [&](int x, int y, double continued) {
        return stream(x, y) > 0.0 ? speed(x, y) * way(x, y, true) : share(x, y) * continued;
    });
    set("velocity_y", 0.0, [&](int x, int y, double continued) {
        return stream(x, y) > 0.0 ? speed(x, y) * way(x, y, false) : share(x, y) * continued;
    });
}

std::function<Grid(double from, double until)> SurroundingPlain::rain_over_tile(
    const Snapshot& snapshot) const {
    if (!snapshot.rain) return {};
    return [this, rain = snapshot.rain, nodata = snapshot.nodata](double from, double until) {
        Grid fallen = rain(from, until);
        if (fallen.size() == 1) return fallen;
        const Grid maps = continued(fallen, *surroundings(nodata));
        Grid tile(nx_, ny_);
        for (int y = 0; y < ny_; ++y) std::copy_n(maps.row(y).begin(), nx_, tile.row(y).begin());
        return tile;
    };
}

}  // namespace fumon
