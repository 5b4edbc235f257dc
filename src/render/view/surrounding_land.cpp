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

void SurroundingPlain::make_land(const Snapshot& first, const Mask& outside,
                                 std::optional<double> known_sea) {
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
    const double closed =
        has_water(first) ? closed_depth(first.scale) / first.scale.height_unit : 0.0;
    for (const std::optional<double>& sea : {known_sea, sea_level(surface, depth, closed)}) {
        sea_ = sea;
        if (sea_ && make_coast(first, outside, *sea_)) return;
    }
    sea_.reset();
    lake_ = lake_of(first, surface, depth);
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
            const bool in_lake = lake_ && lake_->edge.values()[i] != 0;
            lowest = std::min(lowest, in_lake ? lake_->level : heights.values()[i]);
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
    if (lake_) lay_lake(outside, gradient * std::min(dx, dy), cells);
    // From the highest rim down to the plain on the way there is.
    const double way = clear_share * margin * std::min(dx, dy);
    const double needed = (highest - level_ - *std::ranges::min_element(frame)) / way;
    drain_between(own_, cells, dx, dy, least_fall,
                  std::max(steepest_share * slopes.hillslope(), needed));
    downstream_ = route_flow(own_, {}, dx, dy).receiver;
}

std::optional<EdgeLake> SurroundingPlain::lake_of(const Snapshot& first, const Grid& surface,
                                                  const Field<float>& depth) const {
    if (!has_water(first)) return std::nullopt;
    const double unit = first.scale.height_unit;
    const double closed = closed_depth(first.scale) / unit;
    Grid water = in_tile(*field_of(first.fields, "water_depth"));
    for (double& deep : water.values()) deep /= unit;
    Grid speed = in_tile(*field_of(first.fields, "velocity_x"));
    const Grid north = in_tile(*field_of(first.fields, "velocity_y"));
    for (std::size_t i = 0; i < speed.size(); ++i)
        speed.values()[i] = elementary::hypot(speed.values()[i], north.values()[i]);
    return lake_at_edge(surface, water, speed, depth, least_stream * closed, closed);
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
        if (lake_ && lake_->edge.values()[i] != 0) continue;
        const double fast = elementary::hypot(along_x.values()[i], along_y.values()[i]);
        for (std::int32_t cell = downstream_.values()[i]; cell != FlowRouting::outlet;
             cell = downstream_.values()[static_cast<std::size_t>(cell)]) {
            const auto at = static_cast<std::size_t>(cell);
            if (inside(at) || stream.values()[at] >= deep) break;
            stream.values()[at] = deep;
            speed.values()[at] = fast;
        }
    }
    // A lake that falls within the bed does so beyond it.
    double lake = 0.0;
    if (lake_) {
        const Grid heights = in_tile(snapshot.bed);
        std::size_t cells = 0;
        for (std::size_t i = 0; i < heights.size(); ++i) {
            if (lake_->edge.values()[i] == 0) continue;
            lake += heights.values()[i] + depth.values()[i] / snapshot.scale.height_unit;
            ++cells;
        }
        lake = std::min(lake / static_cast<double>(cells), lake_->level);
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
        if (lake_ && lake_cells_(x, y) != 0) return std::max((lake - maps.bed(x, y)) * unit, film);
        const double beside =
            sea_ || lake_ ? film : std::max(continued, 0.0);  // still water wets no land
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
