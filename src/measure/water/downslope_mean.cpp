#include "measure/water/downslope_mean.h"

#include <cstddef>

namespace fumon {

std::vector<double> downslope_mean(const Grid& field, const Mask& nodata) {
    const auto nx = static_cast<std::size_t>(field.nx());
    std::vector<double> mean(nx, 0.0);
    std::vector<int> cells(nx, 0);
    for (int y = 0; y < field.ny(); ++y) {
        const auto row = field.row(y);
        for (std::size_t x = 0; x < nx; ++x) {
            if (!nodata.empty() && nodata.row(y)[x] != 0) continue;
            mean[x] += row[x];
            ++cells[x];
        }
    }
    for (std::size_t x = 0; x < nx; ++x) mean[x] /= cells[x];  // 0/0 is NaN
    return mean;
}

}  // namespace fumon
