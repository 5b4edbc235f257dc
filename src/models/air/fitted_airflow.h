#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "models/air/air_plane.h"
#include "models/air/air_scheme.h"
#include "models/air/airflow_parameters.h"

namespace fumon {

/// The same flow on a grid that follows the bed, ζ = (z − h)/(H − h) in nz steps from bed to lid,
/// by stream function and vorticity:
///
///     u = ∂ψ/∂z,  w = −∂ψ/∂x,   ∇²ψ = ω,   ∂ω/∂t + u ∂ω/∂x + w ∂ω/∂z = ν ∇²ω
///
/// with ψ = 0 on the bed, ψ = Q (uniform) at the lid, and no slip as ω there (Thom 1933). The flux
/// Q is such that the pressure is periodic: ∮ ∂ω/∂z dx = 0 at the lid, where ∂p/∂x = ρν ∂ω/∂z.
/// Central differences, second order; diffusion, ψ, ω and Q implicit in one linear system that is
/// factorised once; advection explicit, first order in time. Velocities are free of divergence by
/// construction.
class FittedAirflow : public AirScheme {
  public:
    FittedAirflow(const AirPlane& plane, const AirflowParameters& parameters);
    ~FittedAirflow() override;

    void step() override;
    /// Interpolated along columns; the pressure follows from the momentum equations, along the lid
    /// and down each column.
    [[nodiscard]] AirFields fields() const override;
    /// ρν (∂u/∂z + ∂w/∂x) as Terada's eq. (38): what it is of the tangential stress ρνω on a wall
    /// of slope h', ρνω (1 − h'²)/(1 + h'²).
    [[nodiscard]] std::vector<double> bed_stress() const override;
    [[nodiscard]] double largest_divergence() const override { return 0.0; }
    [[nodiscard]] std::vector<StateField> state() const override;
    void serialise(StateArchive& archive) override;

  private:
    class Factors;

    [[nodiscard]] double slope(int i) const { return slope_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] double depth(int i) const;
    [[nodiscard]] double along_x(const std::vector<double>& field, int i, int k) const;
    [[nodiscard]] double along_zeta(const std::vector<double>& field, int i, int k) const;
    [[nodiscard]] double zeta_x(int i, int k) const;
    [[nodiscard]] double x_derivative(const std::vector<double>& field, int i, int k) const;
    void add_laplacian(int i, int k, double factor, int row, bool of_vorticity);
    void add_boundaries();
    void start();
    void assemble();
    void velocities(const std::vector<double>& stream, std::vector<double>& u,
                    std::vector<double>& w) const;
    [[nodiscard]] std::vector<double> pressure(const std::vector<double>& u,
                                               const std::vector<double>& w) const;

    AirPlane plane_;
    AirflowParameters parameters_;
    double step_;  ///< of ζ
    std::vector<double> slope_;
    std::vector<double> curvature_;  ///< h'', 1/m
    std::vector<double> stream_;     ///< ψ at nodes of bed-following columns, m²/s
    std::vector<double> last_stream_;
    std::vector<double> vorticity_;  ///< ω, 1/s
    std::unique_ptr<Factors> factors_;
    std::int64_t steps_ = 0;
};

}  // namespace fumon
