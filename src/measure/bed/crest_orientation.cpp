#include "measure/bed/crest_orientation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary_angle.h"
#include "base/units.h"

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
void add_cell(Tensor& tensor, const double* const (&row)[5], const std::size_t (&x)[5]) {
    tensor.add(slope(row[2][x[0]], row[2][x[1]], row[2][x[3]], row[2][x[4]]),
               slope(row[0][x[2]], row[1][x[2]], row[3][x[2]], row[4][x[2]]));
}

Tensor row_tensor(const Grid& bed, int y, bool periodic) {
    const int nx = bed.nx();
    const double* row[5];
    for (int j = 0; j < 5; ++j) row[j] = bed.row((y + j - reach + bed.ny()) % bed.ny()).data();
    Tensor tensor;
    for (int x = reach; x < nx - reach; ++x) {
        const auto at = static_cast<std::size_t>(x);
        add_cell(tensor, row, {at - 2, at - 1, at, at + 1, at + 2});
    }
    for (const int x : {0, 1, nx - 2, nx - 1}) {
        if (!periodic) break;
        std::size_t around[5];
        for (int i = 0; i < 5; ++i) around[i] = static_cast<std::size_t>((x + i - reach + nx) % nx);
        add_cell(tensor, row, around);
    }
    return tensor;
}

}  // namespace

CrestOrientation crest_orientation(const Grid& bed, bool periodic) {
    if (bed.nx() <= 2 * reach || bed.ny() <= 2 * reach) return {};
    const int margin = periodic ? 0 : reach;
    Tensor sum;
    for (int y = margin; y < bed.ny() - margin; ++y) {
        const Tensor row = row_tensor(bed, y, periodic);
        sum.xx += row.xx;
        sum.xy += row.xy;
        sum.yy += row.yy;
    }
    double highest = 0.0;
    for (const double height : bed.values()) highest = std::max(highest, std::abs(height));
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
