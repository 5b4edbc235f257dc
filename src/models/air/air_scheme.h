#pragma once

#include <vector>

#include "models/shared/model.h"

namespace fumon {

/// Velocities (m/s) and pressure (Pa) on the nodes of an AirPlane; 0 at and below the bed.
struct AirFields {
    std::vector<double> u, w, pressure;
};

/// A way to advance the air over a bed.
class AirScheme {
  public:
    AirScheme() = default;
    AirScheme(const AirScheme&) = delete;
    AirScheme& operator=(const AirScheme&) = delete;
    virtual ~AirScheme() = default;

    /// One Δt. Throws Error naming a node where the flow is no longer finite.
    virtual void step() = 0;
    [[nodiscard]] virtual AirFields fields() const = 0;
    /// Of each column, Pa.
    [[nodiscard]] virtual std::vector<double> bed_stress() const = 0;
    /// The largest |∇·v| at a node of the scheme, 1/s.
    [[nodiscard]] virtual double largest_divergence() const = 0;
    /// All that the next step depends on.
    [[nodiscard]] virtual std::vector<StateField> state() const = 0;
    /// Saves or restores that, and what else fields() depends on.
    virtual void serialise(StateArchive& archive) = 0;
};

}  // namespace fumon
