#include "measure/bed/crest_orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/elementary_angle.h"
#include "base/units.h"
#include "measure/bed/row_pass_vectors.h"

namespace fumon {

namespace {

constexpr int reach = 2;
constexpr double rounding_of_slopes = 1e-24;  // of squared slopes, against the highest h²

/// h'(0) from the sites at −2, −1, 1, 2.
double slope(double west2, double west, double east, double east2) {
    return (8.0 * (east - west) - (east2 - west2)) / 12.0;
}

struct Tensor {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void add(double along_x, double along_y) {
        xx += along_x * along_x;
        xy += along_x * along_y;
        yy += along_y * along_y;
    }
};

/// `row[j]` is row y + j − 2; `x[i]` likewise.
void add_cell(Tensor& tensor, const std::array<const double*, 5>& row,
              const std::array<std::size_t, 5>& x) {
    tensor.add(slope(row[2][x[0]], row[2][x[1]], row[2][x[3]], row[2][x[4]]),
               slope(row[0][x[2]], row[1][x[2]], row[3][x[2]], row[4][x[2]]));
}

/// The tensors of rows, a few at a time, so that their sums go side by side.
class RowTensors {
  public:
    static constexpr int rows = 4;

    RowTensors(const Grid& bed, bool periodic)
        : bed_(bed), periodic_(periodic), products_(products_of_rows(bed.nx())) {}

    /// Those of `count` rows from y on.
    std::array<Tensor, rows> from(int y, int count) {
        std::array<Around, rows> around;
        for (int k = 0; k < count; ++k) {
            const auto at = static_cast<std::size_t>(k);
            for (int j = 0; j < 5; ++j) {
                around[at][static_cast<std::size_t>(j)] =
                    bed_.row((y + k + j - reach + bed_.ny()) % bed_.ny()).data();
            }
            row_passes::slope_products(around[at], width(), products(at, 0), products(at, 1),
                                       products(at, 2));
        }
        std::array<Tensor, rows> sums;
        for (std::size_t x = reach; x + reach < width(); ++x) {
            for (std::size_t k = 0; k < rows; ++k) {
                sums[k].xx += products(k, 0)[x];
                sums[k].xy += products(k, 1)[x];
                sums[k].yy += products(k, 2)[x];
            }
        }
        if (periodic_) {
            for (int k = 0; k < count; ++k) {
                const auto at = static_cast<std::size_t>(k);
                add_ends(around[at], sums[at]);
            }
        }
        return sums;
    }

  private:
    using Around = std::array<const double*, 5>;  ///< the rows about a row, the southernmost first

    static std::vector<double> products_of_rows(int nx) {
        return std::vector<double>(static_cast<std::size_t>(nx) * 3 * rows);
    }
    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(bed_.nx()); }
    double* products(std::size_t row, std::size_t which) {
        return products_.data() + (row * 3 + which) * width();
    }
    void add_ends(const Around& row, Tensor& tensor) const {
        const int nx = bed_.nx();
        for (const int x : {0, 1, nx - 2, nx - 1}) {
            std::array<std::size_t, 5> around{};
            for (int i = 0; i < 5; ++i)
                around[static_cast<std::size_t>(i)] =
                    static_cast<std::size_t>((x + i - reach + nx) % nx);
            add_cell(tensor, row, around);
        }
    }

    const Grid& bed_;
    bool periodic_;
    std::vector<double> products_;
};

}  // namespace

CrestOrientation crest_orientation(const Grid& bed, bool periodic) {
    if (bed.nx() <= 2 * reach || bed.ny() <= 2 * reach) return {};
    const int margin = periodic ? 0 : reach;
    Tensor sum;
    RowTensors tensors(bed, periodic);
    const int end = bed.ny() - margin;
    for (int y = margin; y < end; y += RowTensors::rows) {
        const int count = std::min(RowTensors::rows, end - y);
        const auto some = tensors.from(y, count);
        for (int k = 0; k < count; ++k) {
            const Tensor& row = some[static_cast<std::size_t>(k)];
            sum.xx += row.xx;
            sum.xy += row.xy;
            sum.yy += row.yy;
        }
    }
    const double highest = row_passes::highest_magnitude(bed.values());
    const double trace = sum.xx + sum.yy;
    if (!(trace > rounding_of_slopes * highest * highest * static_cast<double>(bed.size())))
        return {};
    CrestOrientation result;
    result.degrees = 0.5 * degrees_per_radian * elementary::atan2(2.0 * sum.xy, sum.xx - sum.yy);
    if (result.degrees <= -90.0) result.degrees = 90.0;
    result.coherence = elementary::hypot(sum.xx - sum.yy, 2.0 * sum.xy) / trace;
    return result;
}

}  // namespace fumon
