// Land and sea around a surveyed bed that ends in the sea.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "measure/network/flow_routing.h"
#include "numerics/smooth_step.h"
#include "render/land/drained_land.h"
#include "render/land/wandering_coast.h"
#include "render/view/surrounding_plain.h"

namespace fumon {

namespace {

constexpr double coast_wander_share = 0.35;      // of the margin: how far aside rivers wander
constexpr double coast_least_fall_share = 1e-3;  // of the mean gradient, from a cell to the next
constexpr double coast_steepest_share = 1.5;     // of hillslopes: valleys' sides
constexpr double hills_begin_within = 6.0;       // cells: hills, at least
constexpr double ends_within_share = 0.3;        // of the margin: what differs from the far floor
constexpr double leads_within = 0.5;             // of the margin: the edge's heights and slopes
constexpr int known_at_end = 3;                  // cells of the tile
constexpr double shore_relief_share = 0.8;       // of the bed's own: in shores
constexpr double lake_begins_within = 8.0;       // cells
constexpr double bank_height = 3.0;              // cells' fall
constexpr double bank_width = 12.0;              // cells
constexpr double below_dry_sea = 3.0;            // cells' fall: so that nothing stands out of it

/// The steepest slope between free cells side by side.
double steepest_free(const Grid& heights, const Field<LandCell>& cells, double dx, double dy) {
    double steepest = 0.0;
    for (int y = 0; y + 1 < heights.ny(); ++y) {
        for (int x = 0; x + 1 < heights.nx(); ++x) {
            if (cells(x, y) != LandCell::free) continue;
            const double height = heights(x, y);
            if (cells(x + 1, y) == LandCell::free)
                steepest = std::max(steepest, std::abs(heights(x + 1, y) - height) / dx);
            if (cells(x, y + 1) == LandCell::free)
                steepest = std::max(steepest, std::abs(heights(x, y + 1) - height) / dy);
        }
    }
    return steepest;
}

}  // namespace

CoastEdge SurroundingPlain::coast_edge(Mask sea, const Mask& outside,
                                       const Field<float>& within) const {
    CoastEdge edge{std::move(sea), Mask(nx_, ny_), static_cast<double>(std::min(west_, south_)),
                   Field<int>(nx_, ny_)};
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            edge.from_end(x, y) =
                std::max(std::min({x, nx_ - 1 - x, y, ny_ - 1 - y}) - known_at_end, 0);
            if (edge.sea(x, y) == 0 && outside(x, y) == 0 && within(x, y) <= 1.5F)
                edge.land(x, y) = 1;
        }
    }
    return edge;
}

bool SurroundingPlain::make_coast(const Snapshot& first, const Mask& outside, double sea) {
    const double dx = first.scale.dx;
    const double dy = first.scale.dy;
    const Grid heights = in_tile(first.bed);
    const Field<float> within = distances_to(outside);
    const int margin = std::min(west_, south_);
    const CoastEdge edge = coast_edge(edge_in_sea(heights, within, sea), outside, within);
    double deep = 0.0;
    std::size_t cells_in_sea = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (edge.sea.values()[i] == 0) continue;
        deep += sea - heights.values()[i];
        ++cells_in_sea;
    }
    if (cells_in_sea == 0) return false;
    deep /= static_cast<double>(cells_in_sea);

    const LandRelief wanted = relief_of(first.bed, first.nodata, dx, dy);
    const SlopeByArea slopes(first.bed, first.nodata, dx, dy);
    const DrainedTile tile =
        drained_tile(relief_, slopes, wanted, dx, dy, coast_wander_share * margin);
    const Grid inland = inland_distances(edge);
    double hills = 0.0;
    for (const double height : tile.heights.values())
        hills += height / static_cast<double>(tile.heights.size());
    Grid standing = heights;
    for (double& height : standing.values()) height = std::max(height - sea, 0.0);
    standing = mean_of(standing, edge.land);
    const double fall = wanted.gradient * std::min(dx, dy);
    const double dip = deep > 0.0 ? 0.0 : below_dry_sea * fall;  // a dry sea is level ground
    const double floor = deep + dip;

    // Over the sea: what land and sea would be without what is known of the edge, and what is
    // missing to that.
    const Field<float>& away = surroundings_->away;
    Grid over(nx_, ny_);
    Grid missing(nx_, ny_);
    for (std::size_t i = 0; i < over.size(); ++i) {
        const double begun =
            outside.values()[i] == 0
                ? 0.0
                : smooth_step(0.0, hills_begin_within, static_cast<double>(away.values()[i]));
        const double at =
            inland.values()[i] + begun * shore_relief_share * relief_.values()[i] / fall;
        const double ends = smooth_step(0.0, ends_within_share * margin,
                                        static_cast<double>(edge.from_end.values()[i]));
        over.values()[i] = at > 0.0 ? eased_rise(at, fall, std::max(standing.values()[i], fall))
                                    : -eased_rise(-at, fall / std::max(ends, 1e-9), floor);
        if (outside.values()[i] != 0) continue;
        const double height = heights.values()[i] - sea;
        missing.values()[i] = height - (height > 0.0 ? 0.0 : dip) - over.values()[i];
    }
    lead_over(missing, within_of_bed(outside, leads_within));

    // Hills lie about the edge's height and begin as gently as they are: else they would stand
    // along it as a wall.
    const double begins = std::max(hills_begin_within, 2.0 * hills / fall);
    own_ = heights;
    Field<LandCell> cells(nx_, ny_, LandCell::free);
    for (std::size_t i = 0; i < own_.size(); ++i) {
        double stands = heights.values()[i] - sea;
        if (outside.values()[i] != 0) {
            stands = over.values()[i] + missing.values()[i];
            const double begun = smooth_step(0.0, begins, static_cast<double>(away.values()[i]));
            const double hilly = smooth_step(0.0, std::max(hills, 1e-9), stands);
            stands += begun * hilly * (tile.heights.values()[i] - hills);
            own_.values()[i] = sea + stands;
        } else {
            cells.values()[i] = LandCell::known;
        }
        if (stands <= 0.0) cells.values()[i] = LandCell::outlet;
    }
    // No gentler than land is elsewhere: valleys' sides would cut its slopes.
    const double steepest =
        std::max(coast_steepest_share * slopes.hillslope(), steepest_free(own_, cells, dx, dy));
    drain_by_valleys(own_, cells, dx, dy, coast_least_fall_share * fall, steepest);
    level_ = sea - deep;
    std::ranges::fill(relief_.values(), 0.0);
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (dip > 0.0 && outside.values()[i] != 0)
            own_.values()[i] = std::max(own_.values()[i], sea);
    downstream_ = route_flow(own_, {}, dx, dy).receiver;
    return true;
}

/// Ground under a lake that reaches over the edge, as deep as it is there, and around it a bank
/// that holds it: no water leaves it.
void SurroundingPlain::lay_lake(const Mask& outside, double fall, Field<LandCell>& cells) {
    const Grid& heights = own_;
    const Field<float>& away = surroundings_->away;
    CoastEdge edge = coast_edge(lake_->edge, outside, distances_to(outside));
    std::swap(edge.sea, edge.land);  // the lake ends as land by a sea does
    const Grid inside = inland_distances(edge);
    const Grid ridges = broad(relief_);
    double deep = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < own_.size(); ++i) {
        if (lake_->edge.values()[i] == 0) continue;
        cells.values()[i] = LandCell::outlet;
        deep += lake_->level - heights.values()[i];
        ++count;
    }
    deep /= static_cast<double>(count);
    lake_cells_ = Mask(nx_, ny_);
    for (std::size_t i = 0; i < own_.size(); ++i) {
        if (outside.values()[i] == 0) continue;
        const double begun =
            smooth_step(0.0, lake_begins_within, static_cast<double>(away.values()[i]));
        const double at = inside.values()[i] - begun * shore_relief_share *
                                                   (relief_.values()[i] - ridges.values()[i]) /
                                                   fall;
        double& height = own_.values()[i];
        if (at > 0.0) {
            const double floor = lake_->level - eased_rise(at, fall, deep);
            height = std::min(std::lerp(height, floor, begun),
                              lake_->level - eased_rise(at, 0.1 * fall, deep));
            cells.values()[i] = LandCell::outlet;
            lake_cells_.values()[i] = 1;
        } else {
            const double bank = eased_rise(-at, 0.5 * fall, bank_height * fall) -
                                fall * std::max(-at - bank_width, 0.0);
            height = std::max(height, lake_->level + bank);
        }
    }
}

}  // namespace fumon
