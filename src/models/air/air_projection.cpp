#include "models/air/air_projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/give_up.h"
#include "base/multiversion.h"
#include "base/state_carrier.h"
#include "models/air/air_plane.h"
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

/// A column's velocities and those of its neighbours, of nodes from 0.
struct Columns {
    const double* __restrict far_left;
    const double* __restrict left;
    const double* __restrict here;
    const double* __restrict right;
    const double* __restrict far_right;
};

struct Coefficients {
    double courant;    ///< Δt/Δr, s/m
    double diffusion;  ///< ν Δt/Δr²
};

/// Eq. (30) at nodes begin … end − 1.
FUMON_MULTIVERSION
void predict_upwind(const Columns& v, const double* __restrict u, const double* __restrict w,
                    double* __restrict out, int begin, int end, const Coefficients& by) {
    const double* __restrict left = v.left;
    const double* __restrict here = v.here;
    const double* __restrict right = v.right;
    for (int k = begin; k < end; ++k) {
        const double centre = here[k];
        const double toward = u[k] > 0.0 ? centre - left[k] : right[k] - centre;
        const double upward = w[k] > 0.0 ? centre - here[k - 1] : here[k + 1] - centre;
        const double around = left[k] + right[k] + here[k - 1] + here[k + 1] - 4.0 * centre;
        out[k] = centre + (by.diffusion * around - by.courant * (u[k] * toward + w[k] * upward));
    }
}

/// The same with linear upwind differences (3f₀ − 4f₁ + f₂)/2 for the advection.
FUMON_MULTIVERSION
void predict_second_order(const Columns& v, const double* __restrict u, const double* __restrict w,
                          double* __restrict out, int begin, int end, const Coefficients& by) {
    const double* __restrict left = v.left;
    const double* __restrict here = v.here;
    const double* __restrict right = v.right;
    for (int k = begin; k < end; ++k) {
        const double centre = here[k];
        const double from_left = 1.5 * centre - 2.0 * left[k] + 0.5 * v.far_left[k];
        const double from_right = 2.0 * right[k] - 1.5 * centre - 0.5 * v.far_right[k];
        const double from_below = 1.5 * centre - 2.0 * here[k - 1] + 0.5 * here[k - 2];
        const double from_above = 2.0 * here[k + 1] - 1.5 * centre - 0.5 * here[k + 2];
        const double toward = u[k] > 0.0 ? from_left : from_right;
        const double upward = w[k] > 0.0 ? from_below : from_above;
        const double around = left[k] + right[k] + here[k - 1] + here[k + 1] - 4.0 * centre;
        out[k] = centre + (by.diffusion * around - by.courant * (u[k] * toward + w[k] * upward));
    }
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
      right_side_(u_) {
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
    give_up_if_asked();
    poisson_.solve(right_side_, p_);
    give_up_if_asked();
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) {
        for (int i = begin; i < end; ++i) extend_pressure(i);
    });
    over_plane(pool_, plane_.nx, u_.size(), [this](int begin, int end) { correct(begin, end); });
    check();
}

void AirProjection::predict(int begin, int end) {
    const Coefficients by{
        parameters_.time_step / plane_.spacing,
        parameters_.viscosity * parameters_.time_step / (plane_.spacing * plane_.spacing)};
    const auto top = [&](int i) { return plane_.under_bed[static_cast<std::size_t>(i)]; };
    for (int i = begin; i < end; ++i) {
        give_up_if_asked();
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
        const double* u = &u_[plane_.at(i, 0)];
        const double* w = &w_[plane_.at(i, 0)];
        const auto advance = [&](const std::vector<double>& v, std::vector<double>& out) {
            const Columns columns{&v[plane_.at(far_left, 0)], &v[plane_.at(left, 0)],
                                  &v[plane_.at(i, 0)], &v[plane_.at(right, 0)],
                                  &v[plane_.at(far_right, 0)]};
            double* result = &out[plane_.at(i, 0)];
            predict_upwind(columns, u, w, result, lowest, from, by);
            predict_second_order(columns, u, w, result, from, to, by);
            predict_upwind(columns, u, w, result, to, plane_.nz, by);
        };
        advance(u_, predicted_u_);
        advance(w_, predicted_w_);
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
        for (int k = plane_.under_bed[static_cast<std::size_t>(i)] + 1; k < plane_.nz; ++k)
            right_side_[plane_.at(i, k)] = factor * divergence(predicted_u_, predicted_w_, i, k);
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
        const double* left = &p_[plane_.at(plane_.left(i), 0)];
        const double* here = &p_[plane_.at(i, 0)];
        const double* right = &p_[plane_.at(plane_.right(i), 0)];
        const std::size_t column = plane_.at(i, 0);
        for (int k = plane_.under_bed[static_cast<std::size_t>(i)] + 1; k < plane_.nz; ++k) {
            const std::size_t at = column + static_cast<std::size_t>(k);
            u_[at] = predicted_u_[at] - factor * (right[k] - left[k]);
            w_[at] = predicted_w_[at] - factor * (here[k + 1] - here[k - 1]);
        }
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

void AirProjection::carry(StateCarrier& carrier) {
    carrier.count("flow_steps", steps_);
    carrier.values("velocity_x", u_);
    carrier.values("velocity_z", w_);
    carrier.values("pressure", p_);
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
    double sum = 0.0;  // not finite once a velocity is not
    for (std::size_t at = 0; at < u_.size(); ++at) sum += u_[at] * 0.0 + w_[at] * 0.0;
    if (std::isfinite(sum)) return;
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
