#include "models/water/water_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/time_table.h"

namespace fumon {

namespace {

bool across_x(GridSide side) {
    return side == GridSide::west || side == GridSide::east;
}

/// m²/s inward, or a level, m.
double value_of(const WaterDomain& domain, const EdgeSegment& segment, double time) {
    const double value = value_at(segment.times, segment.values, time);
    if (segment.kind == EdgeFlow::open) return -std::numeric_limits<double>::infinity();
    if (segment.kind == EdgeFlow::level) return value;
    const double cell = across_x(segment.side) ? domain.dy : domain.dx;
    return value / (cell * (segment.last - segment.first + 1));
}

/// Of the ground along a stretch.
double lowest_ground(const EdgeSegment& segment, const Grid& bed) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int cell = segment.first; cell <= segment.last; ++cell) {
        const bool is_x = across_x(segment.side);
        const int x = is_x ? (segment.side == GridSide::west ? 0 : bed.nx() - 1) : cell;
        const int y = is_x ? cell : (segment.side == GridSide::south ? 0 : bed.ny() - 1);
        lowest = std::min(lowest, bed(x, y));
    }
    return lowest;
}

}  // namespace

WaterEdges::WaterEdges(const WaterDomain& domain, int nx, int ny)
    : domain_(domain), values_(domain.segments.size()) {
    for (std::size_t n = 0; n < domain.segments.size(); ++n) {
        const EdgeSegment& segment = domain.segments[n];
        std::vector<int>& kinds = kinds_[number(segment.side)];
        if (kinds.empty())
            kinds.assign(static_cast<std::size_t>(across_x(segment.side) ? ny : nx), same_as_side);
        const bool flows = segment.kind != EdgeFlow::wall;
        any_flow_ = any_flow_ || flows;
        std::fill(kinds.begin() + segment.first, kinds.begin() + segment.last + 1,
                  flows ? static_cast<int>(n) : wall_cell);
    }
    set_time(0.0);
}

EdgeKind WaterEdges::kind(GridSide side, int cell) const {
    if (has_segments(side)) {
        const int here = kinds_[number(side)][static_cast<std::size_t>(cell)];
        if (here == wall_cell) return EdgeKind::wall;
    }
    return across_x(side) ? domain_.edges_x : domain_.edges_y;
}

void WaterEdges::set_time(double time) {
    for (std::size_t n = 0; n < values_.size(); ++n)
        values_[n] = value_of(domain_, domain_.segments[n], time);
}

EdgeFlux WaterEdges::flux(GridSide side, int cell, const EdgeWater& inside, double gravity) const {
    const auto n = static_cast<std::size_t>(kinds_[number(side)][static_cast<std::size_t>(cell)]);
    const EdgeSegment& segment = domain_.segments[n];
    return segment.kind == EdgeFlow::discharge
               ? discharge_through_edge(inside, values_[n], segment.depth, gravity)
               : level_at_edge(inside, values_[n], gravity);
}

double edge_step_at_courant_one(const WaterDomain& domain, double time, const Grid& bed,
                                double gravity) {
    double fastest = 0.0;  // 1/s
    for (const EdgeSegment& segment : domain.segments) {
        if (segment.kind != EdgeFlow::discharge && segment.kind != EdgeFlow::level) continue;
        const double value = value_of(domain, segment, time);
        double celerity = 0.0;
        if (segment.kind == EdgeFlow::discharge) {
            celerity = root_of_celerity(1.0, 0.0, gravity * value);
            if (segment.depth > 0.0) celerity = std::max(celerity, value / segment.depth);
        } else {
            celerity = std::sqrt(gravity * std::max(value - lowest_ground(segment, bed), 0.0));
        }
        const double size = across_x(segment.side) ? domain.dx : domain.dy;
        fastest = std::max(fastest, 2.0 * celerity / size);
    }
    return fastest > 0.0 ? 1.0 / fastest : std::numeric_limits<double>::infinity();
}

}  // namespace fumon
