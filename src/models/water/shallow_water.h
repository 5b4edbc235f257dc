#pragma once

#include <limits>
#include <vector>

#include "base/grid.h"
#include "models/sediment/face_flows.h"
#include "models/shared/model.h"
#include "models/water/gully_parameters.h"
#include "models/water/watched_faces.h"
#include "models/water/water_settings.h"

namespace fumon {

inline constexpr double millimetre_per_hour = 1.0 / 3.6e6;  ///< in m/s

/// Depth-averaged water, nx × ny each; velocities are 0 where it is dry.
struct Water {
    Grid depth;       ///< h, m
    Grid velocity_x;  ///< u, m/s, eastward
    Grid velocity_y;  ///< v, m/s, northward
};

/// Cells `first` to `last` of a side whose edge has a kind of its own.
struct EdgeSegment {
    GridSide side = GridSide::west;
    int first = 0;
    int last = 0;
    EdgeFlow kind = EdgeFlow::open;
    std::vector<double> times{0.0};   ///< s, rising
    std::vector<double> values{0.0};  ///< m³/s of the whole stretch, or levels, m
    double depth = 0.0;               ///< m, of supercritical inflow; 0: critical
};

/// Where the water flows, fixed for a run.
struct WaterDomain {
    double dx = 1.0;     ///< m
    double dy = 1.0;     ///< m
    double slope = 0.0;  ///< of the mean plane, which descends toward −y: a body force −g·slope
    double slope_x = 0.0;                   ///< … and toward +x: g·slope_x; of finite volumes
    EdgeKind edges_x = EdgeKind::periodic;  ///< never automatic
    EdgeKind edges_y = EdgeKind::periodic;
    std::vector<EdgeSegment> segments;  ///< of finite volumes, on sides that are not periodic
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

    /// Changes depths at the cells' middles, as water is given at the start, to those that the
    /// scheme keeps.
    virtual void convert_to_means(Water& /*water*/, const Grid& /*bed*/) {}

    /// Volume that left over open edges and into cells without data since the start, m³.
    [[nodiscard]] virtual double left() const { return 0.0; }

    /// Volume that came in over edges since the start, m³.
    [[nodiscard]] virtual double entered() const { return 0.0; }

    /// From now on writes into `flows` what passes the faces; of finite volumes.
    virtual void record(FaceFlows& /*flows*/) {}

    /// From now on adds to `faces` what passes them in each sub-step.
    virtual void watch(WatchedFaces& faces) = 0;

    /// From now on rain falls as this grid has it, m/s, and not evenly; null: evenly. It is read as
    /// long as it is set; of finite volumes.
    virtual void set_rain(const Grid* /*rain*/) {}

    /// Takes the discharges and levels at the edges of a time, s.
    virtual void set_time(double /*time*/) {}

    /// The sub-step, s, at which what comes in at that time over this bed has Courant number 1.
    [[nodiscard]] virtual double edge_step_at_courant_one(double /*time*/,
                                                          const Grid& /*bed*/) const {
        return std::numeric_limits<double>::infinity();
    }

    /// What the next sub-step depends on besides the water and the bed, in a fixed order.
    [[nodiscard]] virtual std::vector<StateField> state() const { return {}; }

    /// Saves or restores that, and the volume that has left.
    virtual void serialise(StateArchive& archive) = 0;
};

}  // namespace fumon
