#pragma once

#include <cstddef>

namespace fumon::poisson {

/// Fourier modes that are solved together: their pivots lie side by side, node after node.
inline constexpr std::size_t modes_together = 8;

/// Modes of a plane: node k of mode m at m·stride + k. `stride` is a multiple of 8 above `nodes`.
struct Modes {
    const double* real;
    const double* imaginary;
    double* solved_real;
    double* solved_imaginary;
    std::size_t stride;
    std::size_t nodes;
    std::size_t filled;  ///< nodes from which on `real` and `imaginary` are 0
    double scale;        ///< of these two
    bool anew;           ///< or added to what is solved
};

/// Solves the tridiagonal systems of modes_together modes, by elimination upward and back.
/// `scratch` holds 2·modes_together·(nodes + 8) numbers.
void solve_modes(const Modes& modes, const double* inverse_pivots, double* scratch);

}  // namespace fumon::poisson
