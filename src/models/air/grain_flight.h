#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "models/air/flight_parameters.h"
#include "models/air/grain_lanes_vectors.h"
#include "models/shared/model.h"

namespace fumon {

class WorkerPool;

/// The air in which grains fly, SI units.
struct Air {
    double density = 1.3;       ///< ρ, kg/m³
    double viscosity = 1.5e-5;  ///< ν, m²/s
};

/// Where and how a grain leaves the bed.
struct Launch {
    double x = 0.0;      ///< m
    double angle = 0.0;  ///< θ, to the local bed, degrees
};

/// A flight from the bed to the bed.
struct Flight {
    double x = 0.0;         ///< of the launch, m, within the section's width
    double height = 0.0;    ///< of the bed there, m
    double slope = 0.0;     ///< ∂h/∂x there
    double angle = 0.0;     ///< θ, degrees
    double length = 0.0;    ///< l: how far downwind it landed, m
    double time = 0.0;      ///< s
    double reynolds = 0.0;  ///< the largest particle Reynolds number on the way
};

/// Sand grains in an air flow that they do not change (Terada 2025, sections 2.2 and 4): points of
/// mass m under gravity and drag,
///
///     dv/dt = −g e_z − D (v − u(ξ)),   dξ/dt = v,   v(0) = √(|τ_b|/ρ) at the angle θ + arctan
///     ∂h/∂x
///
/// with D = 3πρνd/m, or that times Schiller and Naumann's factor (eqs. 12–14). Explicit Euler as in
/// figure 18: first the place (eq. 44), then, unless that lies at or below the bed, the velocity
/// with the air's at the new place (eq. 41). The flight's length is that of the first place at or
/// below the bed, so it is up to one step too long.
///
/// What we read: the page with the interpolation (eq. 43) is missing; between the four nodes of a
/// cell we take the bilinear one. The bed between nodes is a straight line, its slope at a node the
/// central difference, where the thesis has the cosine itself. Periodic with the section's full
/// width; figure 18's is one cell shorter.
///
/// Valid while the grains are few (no feedback on the air), and for Stokes' drag below particle
/// Reynolds numbers of about 2, which Flight::reynolds tells.
class GrainFlights {
  public:
    /// Of the section's "velocity_x", "velocity_z" (m/s), "bed_height" (m) and "bed_shear_stress"
    /// (Pa). Throws Error where one is missing, KeyError where the time step is too long for
    /// the drag.
    GrainFlights(const SnapshotSection& section, const FlightParameters& parameters, const Air& air,
                 WorkerPool& pool);

    /// One flight a launch, in their order; the same bytes at any number of threads. Throws Error
    /// for the first grain that leaves through the lid or is not down after `longest_time`.
    [[nodiscard]] std::vector<Flight> fly(std::span<const Launch> launches) const;

    /// A launch from each column at each angle (degrees), angle by angle.
    [[nodiscard]] std::vector<Launch> every_column(std::span<const double> angles) const;

    /// The sums of `hops` flights, each launched at the same angle from where the last one landed:
    /// Flight::length and ::time are totals, ::reynolds the largest. hops ≥ 1. Throws as fly().
    [[nodiscard]] std::vector<Flight> in_succession(std::span<const Launch> launches,
                                                    int hops) const;

    /// Every place of one flight. Throws as fly().
    [[nodiscard]] GrainPath path(const Launch& launch) const;

    static constexpr double longest_time = 2.0;  ///< s

  private:
    struct Start {
        Flight flight;
        double speed_x = 0.0;
        double speed_z = 0.0;
    };
    enum class End : std::uint8_t { landed, left_through_lid, still_up };

    [[nodiscard]] Start start(const Launch& launch) const;
    void advance(GrainLanes& lanes, int count, int steps) const;
    [[nodiscard]] bool is_over(const GrainLanes& lanes, int lane) const;
    [[nodiscard]] End finish(const GrainLanes& lanes, int lane, Flight& flight) const;
    void fly_waiting(std::span<const Launch> launches, std::atomic<std::size_t>& waiting,
                     std::span<Flight> flights, std::span<End> ends) const;
    [[noreturn]] void refuse(const Flight& flight, End end) const;

    LaneAir lane_air_;
    Air air_;
    bool beyond_stokes_;
    double reynolds_per_speed_;  ///< d/ν, s/m
    double steps_at_most_;
    WorkerPool& pool_;
    // One column more than the section's at its east side, twice, and one row more at its top: so
    // the four nodes around any place are there.
    std::vector<double> velocity_x_;
    std::vector<double> velocity_z_;
    std::vector<double> bed_;
    std::vector<double> slope_;
    std::vector<double> stress_;
};

}  // namespace fumon
