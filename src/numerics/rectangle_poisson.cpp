#include "numerics/rectangle_poisson.h"

#include <numbers>

#include "base/elementary.h"
#include "numerics/plane_loop.h"

namespace fumon {

RectanglePoisson::RectanglePoisson(int nx, int nodes, WorkerPool& pool)
    : nx_(nx),
      nodes_(nodes),
      modes_(nx / 2 + 1),
      stride_(static_cast<std::size_t>(chunks(nodes)) * FourierTransform::rows),
      pool_(pool),
      transform_(static_cast<std::size_t>(nx)),
      inverse_pivots_(static_cast<std::size_t>(modes_) * stride_),
      real_(inverse_pivots_.size()),
      imaginary_(inverse_pivots_.size()),
      solved_real_(inverse_pivots_.size()),
      solved_imaginary_(inverse_pivots_.size()) {
    for (int m = 0; m < modes_; ++m) {
        const double diagonal = -4.0 + 2.0 * elementary::cos(2.0 * std::numbers::pi * m / nx);
        double inverse = 0.0;
        for (int k = 0; k < nodes; ++k) {
            inverse = 1.0 / (diagonal + (k + 1 == nodes ? 1.0 : 0.0) - inverse);
            inverse_pivots_[static_cast<std::size_t>(m) * stride_ + static_cast<std::size_t>(k)] =
                inverse;
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
    over_plane(pool_, modes_, size(), [&](int begin, int end) {
        std::vector<double> re(nodes + 1);
        std::vector<double> im(nodes + 1);
        for (int m = begin; m < end; ++m) {
            const std::size_t at = static_cast<std::size_t>(m) * stride_;
            const double* inverse = &inverse_pivots_[at];
            double last_re = 0.0;
            double last_im = 0.0;
            for (std::size_t k = 0; k < nodes; ++k) {
                const bool known = k < filled;
                last_re = ((known ? real_[at + k] * scale : 0.0) - last_re) * inverse[k];
                last_im = ((known ? imaginary_[at + k] * scale : 0.0) - last_im) * inverse[k];
                re[k] = last_re;
                im[k] = last_im;
            }
            for (std::size_t k = nodes; k-- > 0;) {
                re[k] -= inverse[k] * re[k + 1];
                im[k] -= inverse[k] * im[k + 1];
            }
            for (std::size_t k = 0; k < nodes; ++k) {
                solved_real_[at + k] = anew ? re[k] : solved_real_[at + k] + re[k];
                solved_imaginary_[at + k] = anew ? im[k] : solved_imaginary_[at + k] + im[k];
            }
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
