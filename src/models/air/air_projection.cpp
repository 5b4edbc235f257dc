#include "models/air/air_projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/state_archive.h"
#include "models/air/air_plane.h"
#include "models/air/air_vectors.h"
#include "numerics/plane_loop.h"

namespace fumon {

namespace {

/// The shear stress τ = ρν (∂u/∂z + ∂w/∂x) at the bed of each column, Pa, from velocities at the
/// nodes (Terada 2025, eqs. 37–40): extrapolated linearly to z = h from the first node at or above
/// the bed and the one over it. Differences in x at the first node leave out neighbours inside the
/// bed; where both are, that term is 0.
std::vector<double> staircase_stress(const AirPlane& plane, std::span<const double> u,
                                     std::span<const double> w, double dynamic_viscosity) {
    const auto height = [&](int i) {
        return plane.height[static_cast<std::size_t>(i)] / plane.spacing;
    };
    std::vector<double> stress;
    for (int i = 0; i < plane.nx; ++i) {
        const int left = plane.left(i);
        const int right = plane.right(i);
        const int k = static_cast<int>(std::ceil(height(i) - on_bed_tolerance));
        const bool left_free = height(left) <= k + on_bed_tolerance;
        const bool right_free = height(right) <= k + on_bed_tolerance;
        const double here = w[plane.at(i, k)];
        const double rise =
            (right_free ? w[plane.at(right, k)] : here) - (left_free ? w[plane.at(left, k)] : here);
        const double at_node = u[plane.at(i, k + 1)] - u[plane.at(i, k)] +
                               (left_free && right_free ? 0.5 * rise : rise);
        const double above = 0.5 * (u[plane.at(i, k + 2)] - u[plane.at(i, k)] +
                                    w[plane.at(right, k + 1)] - w[plane.at(left, k + 1)]);
        stress.push_back(dynamic_viscosity / plane.spacing *
                         (at_node + (height(i) - k) * (above - at_node)));
    }
    return stress;
}

}  // namespace

AirProjection::AirProjection(const AirPlane& plane, const AirflowParameters& parameters,
                             WorkerPool& pool)
    : plane_(plane),
      parameters_(parameters),
      pool_(pool),
      poisson_(plane, parameters.bed_pressure, pool),
      u_(plane.at(plane.nx, 0), 0.0),
      w_(u_),
      p_(u_),
      right_side_(u_),
      faults_(static_cast<std::size_t>(plane.nx)) {
    const double lid = plane.nz * plane.spacing;
    for (int i = 0; i < plane.nx; ++i) {
        for (int k = plane.under_bed[static_cast<std::size_t>(i)] + 1; k <= plane.nz; ++k) {
            const double above = k * plane.spacing - plane.largest_height;
            u_[plane.at(i, k)] =
                std::max(0.0, parameters.lid_speed * above / (lid - plane.largest_height));
        }
        u_[plane.at(i, plane.nz)] = parameters.lid_speed;
    }
    predicted_u_ = u_;
    predicted_w_ = w_;
}

void AirProjection::step() {
    ++steps_;
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) { predict(begin, end); });
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) { diverge(begin, end); });
    throw_if_cancelled();
    poisson_.solve(right_side_, p_);
    throw_if_cancelled();
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) {
        for (int i = begin; i < end; ++i) extend_pressure(i);
    });
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) { correct(begin, end); });
    check();
}

void AirProjection::predict(int begin, int end) {
    const air::Coefficients by{
        parameters_.time_step / plane_.spacing,
        parameters_.viscosity * parameters_.time_step / (plane_.spacing * plane_.spacing)};
    const auto top = [&](int i) { return plane_.under_bed[static_cast<std::size_t>(i)]; };
    for (int i = begin; i < end; ++i) {
        throw_if_cancelled();
        const int left = plane_.left(i);
        const int right = plane_.right(i);
        const int far_left = plane_.left(left);
        const int far_right = plane_.right(right);
        const int lowest = top(i) + 1;
        int from = plane_.nz;  // second order in nodes from … to − 1
        int to = plane_.nz;
        if (parameters_.advection == AirAdvection::second_order) {
            from = std::max({lowest + 1, top(far_left), top(left), top(right), top(far_right)});
            from = std::min(from, plane_.nz);
            to = std::max(from, plane_.nz - 1);
        }
        const auto columns = [&](const std::vector<double>& v) {
            return air::Columns{&v[plane_.at(far_left, 0)], &v[plane_.at(left, 0)],
                                &v[plane_.at(i, 0)], &v[plane_.at(right, 0)],
                                &v[plane_.at(far_right, 0)]};
        };
        const air::Columns u = columns(u_);
        const air::Columns w = columns(w_);
        const air::NewVelocity out{&predicted_u_[plane_.at(i, 0)], &predicted_w_[plane_.at(i, 0)]};
        if (lowest < from) air::predict_upwind(u, w, by, lowest, from, out);
        if (from < to) air::predict_second_order(u, w, by, from, to, out);
        if (to < plane_.nz) air::predict_upwind(u, w, by, to, plane_.nz, out);
    }
}

double AirProjection::divergence(const std::vector<double>& u, const std::vector<double>& w, int i,
                                 int k) const {
    return u[plane_.at(plane_.right(i), k)] - u[plane_.at(plane_.left(i), k)] +
           w[plane_.at(i, k + 1)] - w[plane_.at(i, k - 1)];
}

void AirProjection::diverge(int begin, int end) {
    const double factor = 0.5 * parameters_.density * plane_.spacing / parameters_.time_step;
    const double at_lid = 2.0 * parameters_.density * parameters_.viscosity / plane_.spacing;
    for (int i = begin; i < end; ++i) {
        air::diverge(&predicted_u_[plane_.at(plane_.left(i), 0)],
                     &predicted_u_[plane_.at(plane_.right(i), 0)], &predicted_w_[plane_.at(i, 0)],
                     factor, plane_.under_bed[static_cast<std::size_t>(i)] + 1, plane_.nz,
                     &right_side_[plane_.at(i, 0)]);
        right_side_[plane_.at(i, plane_.nz - 1)] -=
            at_lid * predicted_w_[plane_.at(i, plane_.nz - 1)];
    }
}

void AirProjection::extend_pressure(int i) {
    const std::size_t lid = plane_.at(i, plane_.nz);
    p_[lid] = p_[lid - 1] + 2.0 * parameters_.density * parameters_.viscosity / plane_.spacing *
                                predicted_w_[lid - 1];
    const std::size_t bed = plane_.at(i, plane_.under_bed[static_cast<std::size_t>(i)]);
    p_[bed] = parameters_.bed_pressure == BedPressure::one_sided ? p_[bed + 1]
                                                                 : 2.0 * p_[bed + 1] - p_[bed + 2];
}

void AirProjection::correct(int begin, int end) {
    const double factor = parameters_.time_step / (2.0 * parameters_.density * plane_.spacing);
    for (int i = begin; i < end; ++i) {
        const std::size_t here = plane_.at(i, 0);
        faults_[static_cast<std::size_t>(i)] = air::correct(
            {nullptr, &p_[plane_.at(plane_.left(i), 0)], &p_[here],
             &p_[plane_.at(plane_.right(i), 0)], nullptr},
            {&predicted_u_[here], &predicted_w_[here]}, factor,
            plane_.under_bed[static_cast<std::size_t>(i)] + 1, plane_.nz, {&u_[here], &w_[here]});
    }
}

AirFields AirProjection::fields() const {
    AirFields fields{u_, w_, p_};
    for (int i = 0; i < plane_.nx; ++i)
        fields.pressure[plane_.at(i, plane_.under_bed[static_cast<std::size_t>(i)])] = 0.0;
    return fields;
}

std::vector<double> AirProjection::bed_stress() const {
    return staircase_stress(plane_, u_, w_, parameters_.density * parameters_.viscosity);
}

std::vector<StateField> AirProjection::state() const {
    return {{"velocity_x", u_}, {"velocity_z", w_}, {"pressure", p_}};
}

void AirProjection::serialise(StateArchive& archive) {
    archive.count("flow_steps", steps_);
    archive.values("velocity_x", u_);
    archive.values("velocity_z", w_);
    archive.values("pressure", p_);
}

double AirProjection::largest_divergence() const {
    double largest = 0.0;
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = plane_.under_bed[static_cast<std::size_t>(i)] + 1; k < plane_.nz; ++k)
            largest = std::max(largest, std::abs(divergence(u_, w_, i, k)));
    }
    return largest / (2.0 * plane_.spacing);
}

void AirProjection::check() const {
    if (std::ranges::all_of(faults_, [](double fault) { return fault == 0.0; })) return;
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 0; k <= plane_.nz; ++k) {
            const std::size_t at = plane_.at(i, k);
            if (std::isfinite(u_[at]) && std::isfinite(w_[at])) continue;
            throw Error(fmt::format(
                "airflow: {} of node ({}, {}) is not finite at t = {:.6g} s; take a smaller "
                "model.time_step{}",
                std::isfinite(u_[at]) ? "velocity_z" : "velocity_x", i, k,
                static_cast<double>(steps_) * parameters_.time_step,
                parameters_.bed_pressure == BedPressure::extrapolated
                    ? " or model.bed_pressure = \"one-sided\""
                    : ""));
        }
    }
}

}  // namespace fumon
