#pragma once

#include <cstddef>

/// The loops of AirProjection and AirPoisson over the nodes of a column.
namespace fumon::air {

/// A column's values and those of its neighbours, of nodes from 0.
struct Columns {
    const double* far_left;
    const double* left;
    const double* here;
    const double* right;
    const double* far_right;
};

struct Velocity {
    const double* u;
    const double* w;
};

struct NewVelocity {
    double* u;
    double* w;
};

struct Coefficients {
    double courant;    ///< Δt/Δr, s/m
    double diffusion;  ///< ν Δt/Δr²
};

/// Terada (2025), eq. 30, at nodes begin … end − 1: advection of both velocities by upwind
/// differences, and diffusion.
void predict_upwind(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                    int end, const NewVelocity& out);

/// The same with linear upwind differences (3f₀ − 4f₁ + f₂)/2 for the advection.
void predict_second_order(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                          int end, const NewVelocity& out);

/// out = factor · (u_right − u_left + w_above − w_below) at nodes begin … end − 1.
void diverge(const double* u_left, const double* u_right, const double* w, double factor, int begin,
             int end, double* out);

/// The velocities less factor times the central differences of the pressure. Returns 0, or what is
/// not a number where one of them is not finite.
double correct(const Columns& pressure, const Velocity& predicted, double factor, int begin,
               int end, const NewVelocity& out);

/// out = a − factor · b.
void subtract_multiple(const double* a, double factor, const double* b, int count, double* out);

/// Rows begin … end − 1 of a square matrix, stored by columns, times a vector.
void multiply(const double* matrix, const double* by, std::size_t size, std::size_t begin,
              std::size_t end, double* product);

}  // namespace fumon::air
