#include "figure/panels/row_means.h"

#include <limits>

namespace fumon {

std::vector<double> row_means(const Grid& field, const Mask& unknown, int first, int last) {
    std::vector<double> means;
    for (int x = 0; x < field.nx(); ++x) {
        double sum = 0.0;
        int count = 0;
        for (int y = first; y <= last; ++y) {
            if (!unknown.empty() && unknown(x, y) != 0) continue;
            sum += field(x, y);
            ++count;
        }
        means.push_back(count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN());
    }
    return means;
}

}  // namespace fumon
