#include "numerics/time_table.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

double value_at(std::span<const double> times, std::span<const double> values, double time) {
    const auto next = std::ranges::upper_bound(times, time);
    if (next == times.begin()) return values.front();
    if (next == times.end()) return values.back();
    const auto k = static_cast<std::size_t>(next - times.begin());
    const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
    return values[k - 1] + share * (values[k] - values[k - 1]);
}

double mean_of_steps(std::span<const double> times, std::span<const double> values, double from,
                     double to) {
    double sum = 0.0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double begin = std::max(from, times[k]);
        const double end = k + 1 < times.size() ? std::min(to, times[k + 1]) : to;
        if (end > begin) sum += values[k] * (end - begin);
    }
    return sum / (to - from);
}

}  // namespace fumon
