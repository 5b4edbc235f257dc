#pragma once

/// The parts of hops that are the same for every cell of a row, as loops over vectors. Rows have
/// `count` cells; `out` may be one of the rows read.
namespace fumon::hop_vectors {

/// tanh(factor · (right − left)).
void tanh_of_differences(const double* left, const double* right, double factor, int count,
                         double* out);

/// Lengths base + factor · in, sites, cut to [0, 2^30], NaN too, so that they can become indices.
void linear(const double* in, double base, double factor, int count, double* out);

/// Lengths base + trunc(factor · in), cut likewise, the term too.
void linear_truncated(const double* in, double base, double factor, int count, double* out);

/// Lengths scale · (e^(rate · in) − 1), cut likewise.
void exponential(const double* in, double scale, double rate, int count, double* out);

/// `amount`, or the height where it is less; none below 0.
void limited_amounts(const double* height, double amount, int count, double* out);

/// base + factor · slope_tanh, none below 0, and no more than the height where `limited`.
void slope_amounts(const double* height, const double* slope_tanh, double base, double factor,
                   bool limited, int count, double* out);

}  // namespace fumon::hop_vectors
