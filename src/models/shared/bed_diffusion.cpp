#include "models/shared/bed_diffusion.h"

#include <algorithm>
#include <array>

#include "base/cancellation.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

/// Several lines, each its own chain: one alone would wait for its own last result.
template <std::size_t lines>
void sweep_lines(double* first, std::ptrdiff_t stride, const double* inverse, double r, int count) {
    std::array<double, lines> last{};
    for (int i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < lines; ++k) {
            double& cell = first[static_cast<std::ptrdiff_t>(k) * stride + i];
            last[k] = (cell + r * last[k]) * inverse[i];
            cell = last[k];
        }
    }
    for (int i = count - 2; i >= 0; --i) {
        const double weight = r * inverse[i];
        for (std::size_t k = 0; k < lines; ++k) {
            double& cell = first[static_cast<std::ptrdiff_t>(k) * stride + i];
            last[k] = cell + weight * last[k];
            cell = last[k];
        }
    }
}

/// Columns that are solved together, so that they stay in the second-level cache from the first row
/// to the last and back.
int columns_at_once(int rows) {
    constexpr int cells = 32 * 1024;
    constexpr int fewest = 16;
    constexpr int multiple = 8;
    return std::max(fewest, cells / (rows + 1) / multiple * multiple);
}

}  // namespace

DiffusionLine::DiffusionLine(int count, double r, bool periodic)
    : r_(r), periodic_(periodic), inverse_(static_cast<std::size_t>(count)) {
    if (nothing_to_do()) return;
    const double middle = 1.0 + 2.0 * r;
    // A periodic matrix is a line plus corners −r: the line's ends take up what makes the corners a
    // product w wᵀ-like of rank one, with the free choice −middle.
    const double choice = -middle;
    double previous = 0.0;
    for (std::size_t i = 0; i < inverse_.size(); ++i) {
        double diagonal = middle;
        if (i == 0) diagonal = periodic ? middle - choice : middle - r;
        if (i + 1 == inverse_.size()) diagonal = periodic ? middle - r * r / choice : middle - r;
        inverse_[i] = 1.0 / (diagonal - (i == 0 ? 0.0 : r * r * previous));
        previous = inverse_[i];
    }
    if (!periodic) return;
    closing_.assign(inverse_.size(), 0.0);
    closing_.front() = choice;
    closing_.back() = -r;
    sweep_lines<1>(closing_.data(), 0, inverse_.data(), r, count);
    closing_end_ = -r / choice;
    closing_weight_ = 1.0 / (1.0 + closing_.front() + closing_end_ * closing_.back());
}

void DiffusionLine::solve_rows(double* first, std::ptrdiff_t stride, int lines) const {
    if (nothing_to_do()) return;
    constexpr int together = BedDiffusion::rows_at_once;
    const int count = static_cast<int>(inverse_.size());
    int k = 0;
    for (; k + together <= lines; k += together)
        sweep_lines<together>(first + k * stride, stride, inverse_.data(), r_, count);
    for (; k < lines; ++k) sweep_lines<1>(first + k * stride, stride, inverse_.data(), r_, count);
    if (!periodic_) return;
    for (k = 0; k < lines; ++k) {
        double* line = first + k * stride;
        const double factor = closing_weight_ * (line[0] + closing_end_ * line[count - 1]);
        bed_diffusion::add_multiple(closing_.data(), -factor, count, line);
    }
}

bed_diffusion::Lines DiffusionLine::across_rows() const {
    return {r_,
            static_cast<int>(inverse_.size()),
            inverse_.data(),
            periodic_ ? closing_.data() : nullptr,
            closing_weight_,
            closing_end_};
}

BedDiffusion::BedDiffusion(int nx, int ny, double diffusion_x, double diffusion_y, bool periodic_x,
                           bool periodic_y, WorkerPool& pool)
    : nx_(nx),
      ny_(ny),
      diffusion_x_(diffusion_x),
      diffusion_y_(diffusion_y),
      periodic_x_(periodic_x),
      periodic_y_(periodic_y),
      pool_(pool),
      half_way_(nx, ny) {}

void BedDiffusion::prepare(double dt) {
    if (dt == dt_) return;
    dt_ = dt;
    rx_ = nx_ > 1 ? 0.5 * diffusion_x_ * dt : 0.0;
    ry_ = ny_ > 1 ? 0.5 * diffusion_y_ * dt : 0.0;
    along_x_ = DiffusionLine(nx_, rx_, periodic_x_);
    along_y_ = DiffusionLine(ny_, ry_, periodic_y_);
}

void BedDiffusion::first_half(const Grid& bed, const Grid& change, int begin, int end) {
    const auto beside = [&](int y, int by) {
        const int other = y + by;
        if (periodic_y_) return (other + ny_) % ny_;
        return std::clamp(other, 0, ny_ - 1);
    };
    for (int y = begin; y < end; ++y) {
        bed_diffusion::explicit_y(bed.row(beside(y, -1)).data(), bed.row(y).data(),
                                  bed.row(beside(y, 1)).data(), change.row(y - begin).data(), ry_,
                                  nx_, half_way_.row(y));
    }
    along_x_.solve_rows(half_way_.row(begin), stride(), end - begin);
    for (int y = begin; y < end; ++y) {
        double* row = half_way_.row(y);
        if (periodic_x_) {
            half_way_.wrap(y);
        } else {
            row[-1] = row[0];
            row[nx_] = row[nx_ - 1];
        }
    }
}

void BedDiffusion::second_half(Grid& bed) {
    const int width = columns_at_once(ny_);
    pool_.for_ranges(nx_, [&](int begin, int end) {
        std::vector<double> scratch(static_cast<std::size_t>(width) *
                                    (static_cast<std::size_t>(ny_) + 1));
        for (int x = begin; x < end; x += width) {
            throw_if_cancelled();
            const int count = std::min(width, end - x);
            if (along_y_.nothing_to_do()) {
                for (int y = 0; y < ny_; ++y) {
                    bed_diffusion::explicit_x(half_way_.row(y) + x, rx_, count,
                                              bed.row(y).data() + x);
                }
            } else {
                bed_diffusion::cross_rows({half_way_.row(0) + x, stride()}, rx_,
                                          along_y_.across_rows(), count, scratch.data(),
                                          bed.row(0).data() + x, nx_);
            }
        }
    });
}

}  // namespace fumon
