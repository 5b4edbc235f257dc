#include "numerics/rectangle_poisson.h"

#include <numbers>

#include "base/elementary.h"
#include "numerics/plane_loop.h"
#include "numerics/poisson_vectors.h"

namespace fumon {

namespace {

constexpr int modes_at_once = static_cast<int>(poisson::modes_together);

}  // namespace

RectanglePoisson::RectanglePoisson(int nx, int nodes, WorkerPool& pool)
    : nx_(nx),
      nodes_(nodes),
      groups_((nx / 2 + modes_at_once) / modes_at_once),
      stride_(static_cast<std::size_t>(chunks(nodes)) * FourierTransform::rows),
      pool_(pool),
      transform_(static_cast<std::size_t>(nx)),
      inverse_pivots_(static_cast<std::size_t>(groups_ * modes_at_once) * stride_),
      real_(inverse_pivots_.size()),
      imaginary_(inverse_pivots_.size()),
      solved_real_(inverse_pivots_.size()),
      solved_imaginary_(inverse_pivots_.size()) {
    for (int m = 0; m <= nx / 2; ++m) {
        double* pivots =
            &inverse_pivots_[static_cast<std::size_t>(m / modes_at_once * modes_at_once) * stride_];
        const double diagonal = -4.0 + 2.0 * elementary::cos(2.0 * std::numbers::pi * m / nx);
        double inverse = 0.0;
        for (int k = 0; k < nodes; ++k) {
            inverse = 1.0 / (diagonal + (k + 1 == nodes ? 1.0 : 0.0) - inverse);
            pivots[k * modes_at_once + m % modes_at_once] = inverse;
        }
    }
}

int RectanglePoisson::chunks(int rows) const {
    const int most = rows < nodes_ ? rows : nodes_;
    constexpr int chunk = static_cast<int>(FourierTransform::rows);
    return (most + chunk - 1) / chunk;
}

void RectanglePoisson::begin(const std::vector<double>& b, int rows) {
    transform(b, rows);
    solve_modes(rows, true);
}

void RectanglePoisson::add(const std::vector<double>& b, int rows) {
    transform(b, rows);
    solve_modes(rows, false);
}

void RectanglePoisson::transform(const std::vector<double>& b, int rows) {
    over_plane(pool_, chunks(rows), size(), [&](int begin, int end) {
        FourierTransform::Scratch scratch = transform_.scratch();
        for (int chunk = begin; chunk < end; ++chunk) {
            const std::size_t at = static_cast<std::size_t>(chunk) * FourierTransform::rows;
            transform_.forward(&b[at], stride_, &real_[at], &imaginary_[at], stride_, scratch);
        }
    });
}

void RectanglePoisson::solve_modes(int rows, bool anew) {
    const auto filled = static_cast<std::size_t>(rows < nodes_ ? rows : nodes_);
    const auto nodes = static_cast<std::size_t>(nodes_);
    const double scale = 1.0 / nx_;
    over_plane(pool_, groups_, size(), [&](int begin, int end) {
        std::vector<double> scratch(2 * poisson::modes_together * (nodes + 8));
        for (int group = begin; group < end; ++group) {
            const std::size_t at = static_cast<std::size_t>(group * modes_at_once) * stride_;
            poisson::solve_modes({&real_[at], &imaginary_[at], &solved_real_[at],
                                  &solved_imaginary_[at], stride_, nodes, filled, scale, anew},
                                 &inverse_pivots_[at], scratch.data());
        }
    });
}

void RectanglePoisson::write(std::vector<double>& p, int rows) {
    over_plane(pool_, chunks(rows), size(), [&](int begin, int end) {
        FourierTransform::Scratch scratch = transform_.scratch();
        for (int chunk = begin; chunk < end; ++chunk) {
            const std::size_t at = static_cast<std::size_t>(chunk) * FourierTransform::rows;
            transform_.backward(&solved_real_[at], &solved_imaginary_[at], stride_, &p[at], stride_,
                                scratch);
        }
    });
}

}  // namespace fumon
