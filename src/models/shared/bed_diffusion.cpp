#include "models/shared/bed_diffusion.h"

#include <algorithm>
#include <array>

#include "base/give_up.h"
#include "base/multiversion.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

/// Four lines at once, each its own chain: one alone would wait for its own last result.
constexpr int lines_at_once = 4;

void sweep_lines(double* first, std::ptrdiff_t stride, const double* inverse, double r, int count) {
    std::array<double, lines_at_once> last{};
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < lines_at_once; ++k) {
            double& cell = first[k * stride + i];
            const auto line = static_cast<std::size_t>(k);
            last[line] = (cell + r * last[line]) * inverse[i];
            cell = last[line];
        }
    }
    for (int i = count - 2; i >= 0; --i) {
        const double weight = r * inverse[i];
        for (int k = 0; k < lines_at_once; ++k) {
            double& cell = first[k * stride + i];
            const auto line = static_cast<std::size_t>(k);
            last[line] = cell + weight * last[line];
            cell = last[line];
        }
    }
}

void sweep_line(double* line, const double* inverse, double r, int count) {
    double last = 0.0;
    for (int i = 0; i < count; ++i) {
        last = (line[i] + r * last) * inverse[i];
        line[i] = last;
    }
    for (int i = count - 2; i >= 0; --i) {
        last = line[i] + r * inverse[i] * last;
        line[i] = last;
    }
}

FUMON_MULTIVERSION
void add_multiple(const double* a, double factor, int count, double* to) {
    for (int x = 0; x < count; ++x) to[x] += factor * a[x];
}

FUMON_MULTIVERSION
void forward_columns(const double* previous, double r, double inverse, int count, double* row) {
    for (int x = 0; x < count; ++x) row[x] = (row[x] + r * previous[x]) * inverse;
}

FUMON_MULTIVERSION
void explicit_y(const double* south, const double* here, const double* north, const double* change,
                double r, int count, double* out) {
    for (int x = 0; x < count; ++x)
        out[x] = here[x] + change[x] + r * ((south[x] - here[x]) + (north[x] - here[x]));
}

FUMON_MULTIVERSION
void explicit_x(const double* here, double r, int begin, int end, double* out) {
    for (int x = begin; x < end; ++x)
        out[x] = here[x] + r * ((here[x - 1] - here[x]) + (here[x + 1] - here[x]));
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
    sweep_line(closing_.data(), inverse_.data(), r, count);
    closing_end_ = -r / choice;
    closing_weight_ = 1.0 / (1.0 + closing_.front() + closing_end_ * closing_.back());
}

void DiffusionLine::solve_rows(double* first, std::ptrdiff_t stride, int lines) const {
    if (nothing_to_do()) return;
    const int count = static_cast<int>(inverse_.size());
    int k = 0;
    for (; k + lines_at_once <= lines; k += lines_at_once)
        sweep_lines(first + k * stride, stride, inverse_.data(), r_, count);
    for (; k < lines; ++k) sweep_line(first + k * stride, inverse_.data(), r_, count);
    if (!periodic_) return;
    for (k = 0; k < lines; ++k) {
        double* line = first + k * stride;
        const double factor = closing_weight_ * (line[0] + closing_end_ * line[count - 1]);
        add_multiple(closing_.data(), -factor, count, line);
    }
}

void DiffusionLine::solve_columns(Grid& grid, int begin, int end) const {
    if (nothing_to_do()) return;
    const int rows = static_cast<int>(inverse_.size());
    const int count = end - begin;
    const auto row = [&](int y) { return grid.row(y).data() + begin; };
    const auto inverse = [this](int y) { return inverse_[static_cast<std::size_t>(y)]; };
    for (int x = 0; x < count; ++x) row(0)[x] *= inverse(0);
    for (int y = 1; y < rows; ++y) {
        give_up_if_asked();
        forward_columns(row(y - 1), r_, inverse(y), count, row(y));
    }
    for (int y = rows - 2; y >= 0; --y) {
        give_up_if_asked();
        add_multiple(row(y + 1), r_ * inverse(y), count, row(y));
    }
    if (!periodic_) return;
    std::vector<double> factors(static_cast<std::size_t>(count));
    for (int x = 0; x < count; ++x) {
        factors[static_cast<std::size_t>(x)] =
            closing_weight_ * (row(0)[x] + closing_end_ * row(rows - 1)[x]);
    }
    for (int y = 0; y < rows; ++y)
        add_multiple(factors.data(), -closing_[static_cast<std::size_t>(y)], count, row(y));
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
    const std::ptrdiff_t stride = nx_ + 2 * PaddedGrid::margin;
    for (int from = begin; from < end; from += lines_at_once) {
        give_up_if_asked();
        const int to = std::min(from + lines_at_once, end);
        for (int y = from; y < to; ++y) {
            explicit_y(bed.row(beside(y, -1)).data(), bed.row(y).data(),
                       bed.row(beside(y, 1)).data(), change.row(y).data(), ry_, nx_,
                       half_way_.row(y));
        }
        along_x_.solve_rows(half_way_.row(from), stride, to - from);
        for (int y = from; y < to; ++y) {
            double* row = half_way_.row(y);
            if (periodic_x_) {
                half_way_.wrap(y);
            } else {
                row[-1] = row[0];
                row[nx_] = row[nx_ - 1];
            }
        }
    }
}

void BedDiffusion::second_half(Grid& bed) {
    pool_.for_ranges(nx_, [&](int begin, int end) {
        for (int y = 0; y < ny_; ++y) {
            give_up_if_asked();
            explicit_x(half_way_.row(y), rx_, begin, end, bed.row(y).data());
        }
        along_y_.solve_columns(bed, begin, end);
    });
}

}  // namespace fumon
