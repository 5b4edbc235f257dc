#include "numerics/plane_filter.h"

#include <algorithm>
#include <cstddef>

#include "base/cancellation.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

constexpr int together = static_cast<int>(FourierTransform::rows);

/// Cells that eight rows turn into columns at once: they stay in the nearest cache.
constexpr std::size_t stretch = 64;

int rounded_up(int count) {
    return (count + together - 1) / together * together;
}

/// Rows of a length of whole memory pages would share a few places of the caches.
int unlike_pages(int columns) {
    constexpr int page = 512;
    return columns % page == 0 ? columns + together : columns;
}

}  // namespace

/// Working memory for eight modes n: rows along x, and their spectra.
struct PlaneFilter::Block {
    explicit Block(const PlaneFilter& filter)
        : scratch(filter.along_x_.scratch()),
          line_real(points(filter)),
          line_imaginary(points(filter)),
          p_real(modes(filter)),
          p_imaginary(modes(filter)),
          q_real(modes(filter)),
          q_imaginary(modes(filter)),
          response(4 * (static_cast<std::size_t>(filter.nx_) / 2 + 1)) {}

    static std::size_t points(const PlaneFilter& filter) {
        return FourierTransform::rows * static_cast<std::size_t>(filter.nx_);
    }
    static std::size_t modes(const PlaneFilter& filter) {
        return FourierTransform::rows * (static_cast<std::size_t>(filter.nx_) / 2 + 1);
    }

    FourierTransform::Scratch scratch;
    std::vector<double> line_real;
    std::vector<double> line_imaginary;
    std::vector<double> p_real;  ///< of the lines' real parts
    std::vector<double> p_imaginary;
    std::vector<double> q_real;  ///< of their imaginary parts
    std::vector<double> q_imaginary;
    std::vector<double> response;
};

PlaneFilter::PlaneFilter(int nx, int ny, WorkerPool& pool)
    : nx_(nx),
      ny_(ny),
      columns_(rounded_up(nx)),
      pool_(pool),
      along_x_(static_cast<std::size_t>(nx)),
      along_y_(static_cast<std::size_t>(ny)),
      last_(columns_ > nx ? Grid(together, ny) : Grid()),
      real_(unlike_pages(columns_), rounded_up(ny / 2 + 1)),
      imaginary_(real_.nx(), real_.ny()) {}

void PlaneFilter::apply(Grid& plane, const Response& response) {
    constexpr std::size_t rows = FourierTransform::rows;
    const auto plane_stride = static_cast<std::size_t>(nx_);
    const auto stride = static_cast<std::size_t>(real_.nx());
    pool_.for_ranges(columns_ / together, [&](int begin, int end) {
        auto scratch = along_y_.scratch();
        for (int block = begin; block < end; ++block) {
            throw_if_cancelled();
            const int from = block * together;
            const bool whole = from + together <= nx_;
            if (!whole) {
                // Columns travel in pairs: what an earlier plane left beside the last one would
                // grow from plane to plane.
                std::ranges::fill(last_.values(), 0.0);
                for (int y = 0; y < ny_; ++y)
                    std::copy_n(&plane(from, y), nx_ - from, &last_(0, y));
            }
            along_y_.forward(whole ? &plane(from, 0) : last_.data(), whole ? plane_stride : rows,
                             &real_(from, 0), &imaginary_(from, 0), stride, scratch);
        }
    });
    pool_.for_ranges(real_.ny() / together, [&](int begin, int end) {
        Block block(*this);
        for (int number = begin; number < end; ++number) {
            throw_if_cancelled();
            filter_block(number * together, response, block);
        }
    });
    pool_.for_ranges(columns_ / together, [&](int begin, int end) {
        auto scratch = along_y_.scratch();
        for (int block = begin; block < end; ++block) {
            throw_if_cancelled();
            const int from = block * together;
            const bool whole = from + together <= nx_;
            along_y_.backward(&real_(from, 0), &imaginary_(from, 0), stride,
                              whole ? &plane(from, 0) : last_.data(), whole ? plane_stride : rows,
                              scratch);
            for (int y = 0; y < ny_ && !whole; ++y)
                std::copy_n(&last_(0, y), nx_ - from, &plane(from, y));
        }
    });
}

/// The modes n = first … first + 7: along x forward, the response, and back. A complex line a + ib
/// has the spectrum P + iQ, where P and Q are those of a and b, and at −m conj P + i conj Q.
void PlaneFilter::filter_block(int first, const Response& response, Block& block) {
    constexpr std::size_t rows = FourierTransform::rows;
    const auto nx = static_cast<std::size_t>(nx_);
    const std::size_t count = nx / 2 + 1;
    for (std::size_t begin = 0; begin < nx; begin += stretch) {
        const std::size_t end = std::min(begin + stretch, nx);
        for (std::size_t l = 0; l < rows; ++l) {
            const auto re = real_.row(first + static_cast<int>(l));
            const auto im = imaginary_.row(first + static_cast<int>(l));
            for (std::size_t x = begin; x < end; ++x) {
                block.line_real[x * rows + l] = re[x];
                block.line_imaginary[x * rows + l] = im[x];
            }
        }
    }
    along_x_.forward(block.line_real.data(), rows, block.p_real.data(), block.p_imaginary.data(),
                     rows, block.scratch);
    along_x_.forward(block.line_imaginary.data(), rows, block.q_real.data(),
                     block.q_imaginary.data(), rows, block.scratch);
    const double share = 1.0 / (static_cast<double>(nx_) * static_cast<double>(ny_));
    const std::span<double> all = block.response;
    const auto r_re = all.subspan(0, count);
    const auto r_im = all.subspan(count, count);
    const auto s_re = all.subspan(2 * count, count);
    const auto s_im = all.subspan(3 * count, count);
    for (std::size_t l = 0; l < rows; ++l) {
        const int n = first + static_cast<int>(l);
        if (n > ny_ / 2) break;  // rows that only fill the block, and stay 0
        response(n, r_re, r_im, s_re, s_im);
        const bool self_mirrored = n == 0 || 2 * n == ny_;
        for (std::size_t m = 0; m < count; ++m) {
            double& pr = block.p_real[m * rows + l];
            double& pi = block.p_imaginary[m * rows + l];
            double& qr = block.q_real[m * rows + l];
            double& qi = block.q_imaginary[m * rows + l];
            // Z(m) = P + iQ, and the conjugate of Z(−m), P − iQ, with the conjugate response.
            const double zr = pr - qi;
            const double zi = pi + qr;
            const double wr = pr + qi;
            const double wi = pi - qr;
            const double zr_new = share * (zr * r_re[m] - zi * r_im[m]);
            const double zi_new = share * (zr * r_im[m] + zi * r_re[m]);
            const double wr_new = share * (wr * s_re[m] + wi * s_im[m]);
            const double wi_new = share * (wi * s_re[m] - wr * s_im[m]);
            pr = 0.5 * (zr_new + wr_new);
            pi = 0.5 * (zi_new + wi_new);
            qr = 0.5 * (zi_new - wi_new);
            qi = 0.5 * (wr_new - zr_new);
            if (self_mirrored) qr = qi = 0.0;
        }
    }
    // A line's spectrum is real where it is its own mirror.
    for (std::size_t l = 0; l < rows; ++l) {
        block.p_imaginary[l] = block.q_imaginary[l] = 0.0;
        if (nx % 2 == 0) {
            block.p_imaginary[(count - 1) * rows + l] = 0.0;
            block.q_imaginary[(count - 1) * rows + l] = 0.0;
        }
    }
    along_x_.backward(block.p_real.data(), block.p_imaginary.data(), rows, block.line_real.data(),
                      rows, block.scratch);
    along_x_.backward(block.q_real.data(), block.q_imaginary.data(), rows,
                      block.line_imaginary.data(), rows, block.scratch);
    for (std::size_t begin = 0; begin < nx; begin += stretch) {
        const std::size_t end = std::min(begin + stretch, nx);
        for (std::size_t l = 0; l < rows; ++l) {
            const int n = first + static_cast<int>(l);
            const bool real_only = n == 0 || 2 * n == ny_;
            if (n > ny_ / 2) break;
            auto re = real_.row(n);
            auto im = imaginary_.row(n);
            for (std::size_t x = begin; x < end; ++x) {
                re[x] = block.line_real[x * rows + l];
                im[x] = real_only ? 0.0 : block.line_imaginary[x * rows + l];
            }
        }
    }
}

}  // namespace fumon
