#pragma once

#include <cstddef>

/// The loops of FourierTransform, of which every point is 8 numbers: the real parts of 4 complex
/// rows, then their imaginary ones.
namespace fumon::fourier {

inline constexpr std::size_t half = 4;
inline constexpr std::size_t rows = 2 * half;

struct Stage {
    std::size_t radix;
    std::size_t parts;   ///< butterflies of one interleaved transform
    std::size_t stride;  ///< interleaved transforms
    std::size_t length;  ///< of the whole
    const double* cosine;
    const double* sine;
    std::size_t from_step = rows;  ///< from a point to the next where it reads, and where it writes
    std::size_t to_step = rows;
    bool mirrored = false;  ///< imaginary parts are written first, then real ones
};

/// Butterflies of 4 points without products.
void butterflies_of_four(const Stage& stage, const double* from, double* to);
void butterflies_of_five(const Stage& stage, const double* from, double* to);
/// Butterflies of any radix by the definition.
void butterflies(const Stage& stage, const double* from, double* to);

/// z·(c − is) of every point, in place.
void rotate_points(double* z, const double* c, const double* s, std::size_t points);
/// The conjugate of z·(c + is) of every point, in place.
void multiply_conjugate(double* z, const double* c, const double* s, std::size_t points);

/// Spectra of 8 real rows that lie a mode `stride` apart.
struct Spectra {
    double* real;
    double* imaginary;
    std::size_t stride;
};

struct ConstSpectra {
    const double* real;
    const double* imaginary;
    std::size_t stride;
};

/// From the transform z of two real rows that travelled as one complex one: the spectrum of each.
void split_spectra(const double* z, std::size_t length, const Spectra& to);
/// i times the conjugate of what split_spectra takes apart.
void merge_spectra(const ConstSpectra& from, std::size_t length, double* z);

}  // namespace fumon::fourier
