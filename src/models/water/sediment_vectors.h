#pragma once

#include "models/water/sediment_rows.h"

/// The powers of the sediment law, as loops over vectors. U^q S^γ = exp(q/2 ln U² + γ/2 ln S²),
/// within 1e-13 of its value.
namespace fumon::sediment {

/// Squares of speeds and slopes up to this count as standing water and a level bed: their powers
/// are 0 in all that matters.
inline constexpr double tiny = 1e-300;

/// In place of S² of a row, the stress above the critical one: K_t U^q S^γ − τ_c, none below 0, and
/// 0 where the water stands.
void stress_row(const FluxLaw& law, const double* u, const double* v, int count, double* excess);

/// In place of positive values, their powers; 0 stays.
void raise_row(double exponent, int count, double* values);

}  // namespace fumon::sediment
