#pragma once

namespace fumon {

/// The water inside at a face of the grid's edge.
struct EdgeWater {
    double depth = 0.0;    ///< h, m
    double outward = 0.0;  ///< velocity across the edge, m/s
    double along = 0.0;    ///< velocity along it, m/s
    double ground = 0.0;   ///< z, m
};

/// What passes the face, per metre.
struct EdgeFlux {
    double mass = 0.0;      ///< outward, m²/s
    double momentum = 0.0;  ///< h u² + g h²/2, m³/s²
    double along = 0.0;     ///< momentum along the edge that goes out, m³/s²
};

/// The largest c ≥ 0 with a c³ + b c² = d: a > 0, d ≥ 0 (Newton from above).
double root_of_celerity(double a, double b, double d);

/// `inflow` m²/s come in, perpendicular to the edge. Where the water inside holds them back, their
/// depth comes from the Riemann invariant u − 2c that it sends to the edge; else they come in with
/// `given_depth`, where they are supercritical in it, or critical.
EdgeFlux discharge_through_edge(const EdgeWater& inside, double inflow, double given_depth,
                                double gravity);

/// The water at the edge stands at `level` (m); its velocity comes from the invariant u + 2c of the
/// water inside, and is at most critical inward. Water that leaves faster than its waves, or falls
/// to a level below the critical depth, leaves freely.
EdgeFlux level_at_edge(const EdgeWater& inside, double level, double gravity);

}  // namespace fumon
