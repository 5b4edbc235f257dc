#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/grid.h"
#include "numerics/fourier_transform.h"

namespace fumon {

class WorkerPool;

/// Multiplies the two-dimensional Fourier transform of a real plane by a response: mode (m, n)
/// stands for exp(2πi (m x / nx + n y / ny)). The same bytes for any number of threads.
class PlaneFilter {
  public:
    /// Fills in the response to the modes (m, n) for m = 0 … nx/2, and to those of (−m, n): real
    /// and imaginary parts. Called for n = 0 … ny/2, by several threads. The plane that results is
    /// real: what a response to (−m, −n) is that is not the conjugate of that to (m, n) does not
    /// count.
    using Response =
        std::function<void(int n, std::span<double> real, std::span<double> imaginary,
                           std::span<double> mirrored_real, std::span<double> mirrored_imaginary)>;

    PlaneFilter(int nx, int ny, WorkerPool& pool);

    /// In place.
    void apply(Grid& plane, const Response& response);

  private:
    struct Block;

    void filter_block(int first, const Response& response, Block& block);

    int nx_;
    int ny_;
    int columns_;  ///< nx, up to a multiple of what the transform takes at once
    WorkerPool& pool_;
    FourierTransform along_x_;
    FourierTransform along_y_;
    Grid last_;  ///< the columns past the last whole block, with zeros beside them
    Grid real_;  ///< of the modes along y, row n, column x
    Grid imaginary_;
};

}  // namespace fumon
