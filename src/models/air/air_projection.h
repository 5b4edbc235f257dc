#pragma once

#include <vector>

#include "models/air/air_plane.h"
#include "models/air/air_poisson.h"
#include "models/air/air_scheme.h"
#include "models/air/airflow_parameters.h"

namespace fumon {

class WorkerPool;

/// Incompressible flow over a bed by the projection method of Terada (2025, section 3) on a plane
/// of nodes that carry velocity and pressure alike:
///
///     v* = v + Δt (ν ∇²v − (v·∇)v)                        (eqs. 29, 30)
///     ∇²p = (ρ/Δt) ∇·v*                                   (eq. 33: compact Laplacian)
///     v  = v* − (Δt/ρ) ∇p                                 (eq. 34: central differences)
///
/// Periodic in x; v = (u0, 0) at the lid; v = 0 at nodes at and below the bed, a staircase. Since
/// the Laplacian is not the divergence of the gradient, ∇·v is small, not 0. Pressures are solved
/// exactly, where the thesis stops a Gauss–Seidel iteration at a tolerance it does not give.
class AirProjection : public AirScheme {
  public:
    /// At rest up to the bed's highest point, Couette flow from there to the lid (eq. 8).
    AirProjection(const AirPlane& plane, const AirflowParameters& parameters, WorkerPool& pool);

    /// One Δt. Throws Error naming a node whose velocity is no longer finite.
    void step() override;

    [[nodiscard]] AirFields fields() const override;
    [[nodiscard]] std::vector<double> bed_stress() const override;
    /// By central differences.
    [[nodiscard]] double largest_divergence() const override;
    [[nodiscard]] std::vector<StateField> state() const override;
    void serialise(StateArchive& archive) override;

  private:
    void predict(int begin, int end);
    void diverge(int begin, int end);
    void correct(int begin, int end);
    void extend_pressure(int i);
    [[nodiscard]] double divergence(const std::vector<double>& u, const std::vector<double>& w,
                                    int i, int k) const;
    void check() const;

    AirPlane plane_;
    AirflowParameters parameters_;
    WorkerPool& pool_;
    AirPoisson poisson_;
    std::vector<double> u_, w_, p_;
    std::vector<double> predicted_u_, predicted_w_;
    std::vector<double> right_side_;
    std::vector<double> faults_;  ///< of each column: 0 where its velocities are finite
    std::int64_t steps_ = 0;
};

}  // namespace fumon
