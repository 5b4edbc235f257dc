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
double value_of(const WaterDomain& domain, const EdgeStretch& stretch, double time) {
    const double value = value_at(stretch.times, stretch.values, time);
    if (stretch.kind == EdgeFlow::open) return -std::numeric_limits<double>::infinity();
    if (stretch.kind == EdgeFlow::level) return value;
    const double cell = across_x(stretch.side) ? domain.dy : domain.dx;
    return value / (cell * (stretch.last - stretch.first + 1));
}

/// Of the ground along a stretch.
double lowest_ground(const EdgeStretch& stretch, const Grid& bed) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int cell = stretch.first; cell <= stretch.last; ++cell) {
        const bool is_x = across_x(stretch.side);
        const int x = is_x ? (stretch.side == GridSide::west ? 0 : bed.nx() - 1) : cell;
        const int y = is_x ? cell : (stretch.side == GridSide::south ? 0 : bed.ny() - 1);
        lowest = std::min(lowest, bed(x, y));
    }
    return lowest;
}

}  // namespace

WaterEdges::WaterEdges(const WaterDomain& domain, int nx, int ny)
    : domain_(domain), values_(domain.stretches.size()) {
    for (std::size_t n = 0; n < domain.stretches.size(); ++n) {
        const EdgeStretch& stretch = domain.stretches[n];
        std::vector<int>& kinds = kinds_[number(stretch.side)];
        if (kinds.empty())
            kinds.assign(static_cast<std::size_t>(across_x(stretch.side) ? ny : nx), as_the_side);
        const bool flows = stretch.kind != EdgeFlow::wall;
        any_flow_ = any_flow_ || flows;
        std::fill(kinds.begin() + stretch.first, kinds.begin() + stretch.last + 1,
                  flows ? static_cast<int>(n) : wall_here);
    }
    set_time(0.0);
}

EdgeKind WaterEdges::kind(GridSide side, int cell) const {
    if (has_stretches(side)) {
        const int here = kinds_[number(side)][static_cast<std::size_t>(cell)];
        if (here == wall_here) return EdgeKind::wall;
    }
    return across_x(side) ? domain_.edges_x : domain_.edges_y;
}

void WaterEdges::set_time(double time) {
    for (std::size_t n = 0; n < values_.size(); ++n)
        values_[n] = value_of(domain_, domain_.stretches[n], time);
}

EdgeFlux WaterEdges::flux(GridSide side, int cell, const EdgeWater& inside, double gravity) const {
    const auto n = static_cast<std::size_t>(kinds_[number(side)][static_cast<std::size_t>(cell)]);
    const EdgeStretch& stretch = domain_.stretches[n];
    return stretch.kind == EdgeFlow::discharge
               ? discharge_through_edge(inside, values_[n], stretch.depth, gravity)
               : level_at_edge(inside, values_[n], gravity);
}

double edge_step_at_courant_one(const WaterDomain& domain, double time, const Grid& bed,
                                double gravity) {
    double fastest = 0.0;  // 1/s
    for (const EdgeStretch& stretch : domain.stretches) {
        if (stretch.kind != EdgeFlow::discharge && stretch.kind != EdgeFlow::level) continue;
        const double value = value_of(domain, stretch, time);
        double celerity = 0.0;
        if (stretch.kind == EdgeFlow::discharge) {
            celerity = root_of_celerity(1.0, 0.0, gravity * value);
            if (stretch.depth > 0.0) celerity = std::max(celerity, value / stretch.depth);
        } else {
            celerity = std::sqrt(gravity * std::max(value - lowest_ground(stretch, bed), 0.0));
        }
        const double size = across_x(stretch.side) ? domain.dx : domain.dy;
        fastest = std::max(fastest, 2.0 * celerity / size);
    }
    return fastest > 0.0 ? 1.0 / fastest : std::numeric_limits<double>::infinity();
}

}  // namespace fumon
