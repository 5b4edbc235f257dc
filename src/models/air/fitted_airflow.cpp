#include "models/air/fitted_airflow.h"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/state_archive.h"
#include "numerics/eigen_blocks.h"

namespace fumon {

/// Unknowns: ψ at nodes 1 … nz − 1 and ω at nodes 0 … nz of each column, then Q.
class FittedAirflow::Factors {
  public:
    explicit Factors(const AirPlane& plane)
        : nx_(plane.nx), nz_(plane.nz), known(Eigen::VectorXd::Zero(flux() + 1)) {}

    [[nodiscard]] int stream(int i, int k) const { return 2 * nz_ * i + 2 * k; }
    [[nodiscard]] int vorticity(int i, int k) const {
        return 2 * nz_ * i + (k < nz_ ? 2 * k + 1 : 0);
    }
    [[nodiscard]] int flux() const { return 2 * nz_ * nx_; }

    void add(int row, int column, double value) { entries_.emplace_back(row, column, value); }
    /// ψ, which is 0 on the bed and Q at the lid.
    void add_stream(int row, int i, int k, double value) {
        if (k > 0) add(row, k < nz_ ? stream(i, k) : flux(), value);
    }

    void factorise() {
        Eigen::SparseMatrix<double> matrix(flux() + 1, flux() + 1);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        entries_ = {};
        same_eigen_blocks_everywhere();
        lu_.compute(matrix);
        if (lu_.info() != Eigen::Success) throw Error("airflow: the fitted grid has no solution");
    }
    [[nodiscard]] Eigen::VectorXd solve() const { return lu_.solve(known); }

  private:
    int nx_;
    int nz_;
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;

  public:
    Eigen::VectorXd known;
};

FittedAirflow::FittedAirflow(const AirPlane& plane, const AirflowParameters& parameters)
    : plane_(plane),
      parameters_(parameters),
      step_(1.0 / plane.nz),
      stream_(plane.at(plane.nx, 0)),
      vorticity_(stream_),
      factors_(std::make_unique<Factors>(plane)) {
    for (int i = 0; i < plane.nx; ++i) {
        const int left = plane.left(i);
        const int right = plane.right(i);
        const auto height = [&](int column) {
            return plane.height[static_cast<std::size_t>(column)];
        };
        const double near = height(right) - height(left);
        const double far = height(plane.right(right)) - height(plane.left(left));
        slope_.push_back((8.0 * near - far) / (12.0 * plane.spacing));
        const double near_sum = height(right) + height(left);
        const double far_sum = height(plane.right(right)) + height(plane.left(left));
        curvature_.push_back((16.0 * near_sum - far_sum - 30.0 * height(i)) /
                             (12.0 * plane.spacing * plane.spacing));
    }
    start();
    assemble();
}

FittedAirflow::~FittedAirflow() = default;

double FittedAirflow::depth(int i) const {
    return plane_.nz * plane_.spacing - plane_.height[static_cast<std::size_t>(i)];
}

double FittedAirflow::along_x(const std::vector<double>& field, int i, int k) const {
    return (field[plane_.at(plane_.right(i), k)] - field[plane_.at(plane_.left(i), k)]) /
           (2.0 * plane_.spacing);
}

double FittedAirflow::along_zeta(const std::vector<double>& field, int i, int k) const {
    const std::size_t at = plane_.at(i, k);
    if (k == 0) return (4.0 * field[at + 1] - 3.0 * field[at] - field[at + 2]) / (2.0 * step_);
    if (k == plane_.nz)
        return (3.0 * field[at] - 4.0 * field[at - 1] + field[at - 2]) / (2.0 * step_);
    return (field[at + 1] - field[at - 1]) / (2.0 * step_);
}

double FittedAirflow::zeta_x(int i, int k) const {
    return -slope(i) * (1.0 - k * step_) / depth(i);
}

double FittedAirflow::x_derivative(const std::vector<double>& field, int i, int k) const {
    return along_x(field, i, k) + zeta_x(i, k) * along_zeta(field, i, k);
}

/// Couette flow above the bed's highest point, rest below.
void FittedAirflow::start() {
    const double room = plane_.nz * plane_.spacing - plane_.largest_height;
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 0; k <= plane_.nz; ++k) {
            const double z = plane_.height[static_cast<std::size_t>(i)] + k * step_ * depth(i);
            const double above = std::max(0.0, z - plane_.largest_height);
            stream_[plane_.at(i, k)] = 0.5 * parameters_.lid_speed * above * above / room;
            vorticity_[plane_.at(i, k)] = above > 0.0 ? parameters_.lid_speed / room : 0.0;
        }
    }
    last_stream_ = stream_;
}

/// factor · ∇² of ψ or ω at node k of column i, 0 < k < nz.
void FittedAirflow::add_laplacian(int i, int k, double factor, int row, bool of_vorticity) {
    const auto add = [&](int column, int node, double value) {
        if (of_vorticity) {
            factors_->add(row, factors_->vorticity(column, node), factor * value);
        } else {
            factors_->add_stream(row, column, node, factor * value);
        }
    };
    const double down = 1.0 - k * step_;
    const double d = depth(i);
    const double tilt = zeta_x(i, k);
    const double across = tilt / (2.0 * plane_.spacing * step_);
    const double over_x = 1.0 / (plane_.spacing * plane_.spacing);
    const double over_zeta = (tilt * tilt + 1.0 / (d * d)) / (step_ * step_);
    const double bend =
        -down * (curvature_[static_cast<std::size_t>(i)] / d + 2.0 * slope(i) * slope(i) / (d * d));
    const int left = plane_.left(i);
    const int right = plane_.right(i);
    add(i, k, -2.0 * (over_x + over_zeta));
    add(left, k, over_x);
    add(right, k, over_x);
    add(i, k + 1, over_zeta + bend / (2.0 * step_));
    add(i, k - 1, over_zeta - bend / (2.0 * step_));
    add(right, k + 1, across);
    add(left, k + 1, -across);
    add(right, k - 1, -across);
    add(left, k - 1, across);
}

void FittedAirflow::assemble() {
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 1; k < plane_.nz; ++k) {
            const int of_stream = factors_->stream(i, k);
            add_laplacian(i, k, 1.0, of_stream, false);
            factors_->add(of_stream, factors_->vorticity(i, k), -1.0);
            const int of_vorticity = factors_->vorticity(i, k);
            factors_->add(of_vorticity, of_vorticity, 1.0);
            add_laplacian(i, k, -parameters_.viscosity * parameters_.time_step, of_vorticity, true);
        }
    }
    add_boundaries();
    factors_->factorise();
}

void FittedAirflow::add_boundaries() {
    const int nz = plane_.nz;
    const int flux = factors_->flux();
    for (int i = 0; i < plane_.nx; ++i) {
        const double d = depth(i);
        const double steepness = 1.0 + slope(i) * slope(i);
        const double over = 2.0 / (d * d * step_ * step_);
        const int at_bed = factors_->vorticity(i, 0);
        factors_->add(at_bed, at_bed, 1.0);
        factors_->add_stream(at_bed, i, 1, -steepness * over);
        const int at_lid = factors_->vorticity(i, nz);
        factors_->add(at_lid, at_lid, 1.0);
        factors_->add_stream(at_lid, i, nz - 1, -over);
        factors_->add(at_lid, flux, over);
        factors_->known[at_lid] = over * step_ * parameters_.lid_speed * d;
        const double weight = plane_.spacing / d;
        factors_->add(flux, at_lid, 3.0 * weight);
        factors_->add(flux, factors_->vorticity(i, nz - 1), -4.0 * weight);
        factors_->add(flux, factors_->vorticity(i, nz - 2), weight);
    }
}

void FittedAirflow::step() {
    ++steps_;
    for (int i = 0; i < plane_.nx; ++i) {
        throw_if_cancelled();
        for (int k = 1; k < plane_.nz; ++k) {
            const double carried = (along_zeta(stream_, i, k) * along_x(vorticity_, i, k) -
                                    along_x(stream_, i, k) * along_zeta(vorticity_, i, k)) /
                                   depth(i);
            factors_->known[factors_->vorticity(i, k)] =
                vorticity_[plane_.at(i, k)] - parameters_.time_step * carried;
        }
    }
    const Eigen::VectorXd solution = factors_->solve();
    last_stream_ = stream_;
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 0; k <= plane_.nz; ++k) {
            const std::size_t at = plane_.at(i, k);
            vorticity_[at] = solution[factors_->vorticity(i, k)];
            if (k > 0)
                stream_[at] = solution[k < plane_.nz ? factors_->stream(i, k) : factors_->flux()];
            if (std::isfinite(vorticity_[at])) continue;
            throw Error(
                fmt::format("airflow: the vorticity of node ({}, {}) is not finite at t = "
                            "{:.6g} s; take a smaller model.time_step",
                            i, k, static_cast<double>(steps_) * parameters_.time_step));
        }
    }
}

void FittedAirflow::velocities(const std::vector<double>& stream, std::vector<double>& u,
                               std::vector<double>& w) const {
    u.assign(stream.size(), 0.0);
    w.assign(stream.size(), 0.0);
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 1; k < plane_.nz; ++k) {
            u[plane_.at(i, k)] = along_zeta(stream, i, k) / depth(i);
            w[plane_.at(i, k)] = -x_derivative(stream, i, k);
        }
        u[plane_.at(i, plane_.nz)] = parameters_.lid_speed;
    }
}

std::vector<double> FittedAirflow::pressure(const std::vector<double>& u,
                                            const std::vector<double>& w) const {
    std::vector<double> last_u;
    std::vector<double> last_w;
    velocities(last_stream_, last_u, last_w);
    const double dynamic = parameters_.density * parameters_.viscosity;
    const auto along_lid = [&](int i) {
        return dynamic * along_zeta(vorticity_, i, plane_.nz) / depth(i);
    };
    /// ∂p/∂ζ
    const auto downward = [&](int i, int k) {
        const std::size_t at = plane_.at(i, k);
        const double change = (w[at] - last_w[at]) / parameters_.time_step;
        const double carried =
            u[at] * x_derivative(w, i, k) + w[at] * along_zeta(w, i, k) / depth(i);
        return -depth(i) * (parameters_.density * (change + carried) +
                            dynamic * x_derivative(vorticity_, i, k));
    };
    std::vector<double> p(u.size());
    double at_lid = 0.0;
    for (int i = 0; i < plane_.nx; ++i) {
        if (i > 0) at_lid += 0.5 * plane_.spacing * (along_lid(i - 1) + along_lid(i));
        p[plane_.at(i, plane_.nz)] = at_lid;
        for (int k = plane_.nz - 1; k >= 0; --k) {
            p[plane_.at(i, k)] =
                p[plane_.at(i, k + 1)] - 0.5 * step_ * (downward(i, k) + downward(i, k + 1));
        }
    }
    const double zero = p[plane_.at(0, 0)];
    for (double& value : p) value -= zero;
    return p;
}

AirFields FittedAirflow::fields() const {
    std::vector<double> u;
    std::vector<double> w;
    velocities(stream_, u, w);
    const std::vector<double> p = pressure(u, w);
    const std::vector<double> nothing(u.size(), 0.0);
    AirFields on_plane{nothing, nothing, nothing};
    for (int i = 0; i < plane_.nx; ++i) {
        const double height = plane_.height[static_cast<std::size_t>(i)];
        for (int k = plane_.under_bed[static_cast<std::size_t>(i)] + 1; k <= plane_.nz; ++k) {
            const double place = (k * plane_.spacing - height) / (depth(i) * step_);
            const int below = std::clamp(static_cast<int>(place), 0, plane_.nz - 1);
            const double part = place - below;
            const std::size_t from = plane_.at(i, below);
            const auto between = [&](const std::vector<double>& field) {
                return field[from] + part * (field[from + 1] - field[from]);
            };
            on_plane.u[plane_.at(i, k)] = between(u);
            on_plane.w[plane_.at(i, k)] = between(w);
            on_plane.pressure[plane_.at(i, k)] = between(p);
        }
    }
    return on_plane;
}

std::vector<double> FittedAirflow::bed_stress() const {
    std::vector<double> stress;
    for (int i = 0; i < plane_.nx; ++i) {
        const double square = slope(i) * slope(i);
        stress.push_back(parameters_.density * parameters_.viscosity * vorticity_[plane_.at(i, 0)] *
                         (1.0 - square) / (1.0 + square));
    }
    return stress;
}

std::vector<StateField> FittedAirflow::state() const {
    return {{"stream_function", stream_}, {"vorticity", vorticity_}};
}

void FittedAirflow::serialise(StateArchive& archive) {
    archive.count("flow_steps", steps_);
    archive.values("stream_function", stream_);
    archive.values("last_stream_function", last_stream_);
    archive.values("vorticity", vorticity_);
}

}  // namespace fumon
