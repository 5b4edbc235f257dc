#pragma once

#include <vector>

#include "base/grid.h"
#include "models/shared/model.h"
#include "models/water/gully_parameters.h"

namespace fumon {

/// Depth-averaged water, nx × ny each; velocities are 0 where it is dry.
struct Water {
    Grid depth;       ///< h, m
    Grid velocity_x;  ///< u, m/s, eastward
    Grid velocity_y;  ///< v, m/s, northward
};

/// Where the water flows, fixed for a run.
struct WaterDomain {
    double dx = 1.0;     ///< m
    double dy = 1.0;     ///< m
    double slope = 0.0;  ///< of the mean plane, which descends toward −y: a body force −g·slope
    EdgeKind edges_x = EdgeKind::periodic;  ///< never automatic
    EdgeKind edges_y = EdgeKind::periodic;
    Mask nodata;  ///< empty, or 1 outside the domain: water that gets there is gone
};

/// A way to advance shallow water over a bed:
///
///     Du/Dt = −g ∂(h+z)/∂x − τx/(ρh)     Dv/Dt = −g ∂(h+z)/∂y − g·slope − τy/(ρh)
///     ∂h/∂t + ∇·(h u) = rain             τ = ρ C_f |u| u, or half of it   (Saeki & Okamura 2007,
///                                                                          eqs. 1–3, 6, 9)
///
/// where the mean plane pulls toward −y. A scheme may keep a state of its own besides the water
/// (for CIP, gradients).
class ShallowWaterScheme {
  public:
    ShallowWaterScheme() = default;
    ShallowWaterScheme(const ShallowWaterScheme&) = delete;
    ShallowWaterScheme& operator=(const ShallowWaterScheme&) = delete;
    virtual ~ShallowWaterScheme() = default;

    /// The sub-step, s, at which the Courant number would be 1: for the model to scale.
    [[nodiscard]] virtual double step_at_courant_one(const Water& water) const = 0;

    /// Advances the water by `dt` seconds over `bed` (m, departures from the mean plane) with
    /// `rain` in m/s. Returns step_at_courant_one of the water that it leaves.
    virtual double advance(Water& water, const Grid& bed, double dt, double rain) = 0;

    /// Volume that left over open edges and into cells without data since the start, m³.
    [[nodiscard]] virtual double left() const { return 0.0; }

    /// What the next sub-step depends on besides the water and the bed, in a fixed order.
    [[nodiscard]] virtual std::vector<StateField> state() const { return {}; }

    /// Saves or restores that, and the volume that has left.
    virtual void carry(StateCarrier& carrier) = 0;
};

}  // namespace fumon
