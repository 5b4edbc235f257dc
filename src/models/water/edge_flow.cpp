#include "models/water/edge_flow.h"

#include <algorithm>
#include <cmath>

namespace fumon {

namespace {

EdgeFlux flux_of(double depth, double outward, double along, double gravity) {
    const double mass = depth * outward;
    return {mass, mass * outward + 0.5 * gravity * (depth * depth),
            mass > 0.0 ? mass * along : 0.0};
}

/// As over a fall: as it comes where it is supercritical, else critical, by the invariant u + 2c.
EdgeFlux free_outflow(const EdgeWater& inside, double celerity, double gravity) {
    if (inside.outward >= celerity)
        return flux_of(inside.depth, inside.outward, inside.along, gravity);
    const double critical = (inside.outward + 2.0 * celerity) / 3.0;
    if (!(critical > 0.0)) return {};
    return flux_of(critical * critical / gravity, critical, inside.along, gravity);
}

}  // namespace

double root_of_celerity(double a, double b, double d) {
    double c = std::max(-b / a, 0.0) + std::max(1.0, d / a);
    constexpr int most_rounds = 200;
    for (int round = 0; round < most_rounds; ++round) {
        const double rise = c * (3.0 * a * c + 2.0 * b);
        if (!(rise > 0.0)) break;
        const double next = c - (c * c * (a * c + b) - d) / rise;
        if (!(next < c)) break;
        c = next;
    }
    return std::max(c, 0.0);
}

EdgeFlux discharge_through_edge(const EdgeWater& inside, double inflow, double given_depth,
                                double gravity) {
    const double waves = std::sqrt(gravity * given_depth);
    if (given_depth > 0.0 && inflow > given_depth * waves)
        return flux_of(given_depth, -inflow / given_depth, 0.0, gravity);
    const double invariant = -inside.outward - 2.0 * std::sqrt(gravity * inside.depth);
    double c = root_of_celerity(2.0, invariant, gravity * inflow);
    if (gravity * inflow > c * c * c) c = root_of_celerity(1.0, 0.0, gravity * inflow);
    const double depth = c * c / gravity;
    if (!(depth > 0.0)) return {};
    EdgeFlux flux = flux_of(depth, -inflow / depth, 0.0, gravity);
    flux.mass = -inflow;  // to the last bit
    return flux;
}

EdgeFlux level_at_edge(const EdgeWater& inside, double level, double gravity) {
    const double celerity = std::sqrt(gravity * inside.depth);
    const double depth = level - inside.ground;
    if (!(depth > 0.0)) return free_outflow(inside, celerity, gravity);
    const double c = std::sqrt(gravity * depth);
    const double outward = (inside.outward + 2.0 * celerity) - 2.0 * c;
    if (outward > c) return free_outflow(inside, celerity, gravity);
    return flux_of(depth, std::max(outward, -c), inside.along, gravity);
}

}  // namespace fumon
