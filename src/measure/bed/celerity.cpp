#include "measure/bed/celerity.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "measure/bed/row_spectrum.h"
#include "numerics/peak_offset.h"

namespace fumon {

namespace {

constexpr double least_correlation = 0.3;
constexpr double as_good_as_the_highest = 0.8;

}  // namespace

Celerity celerity_along_x(const Grid& earlier, const Grid& later, std::int64_t steps) {
    if (steps < 1) throw Error("a celerity needs two snapshots at least one step apart");
    const std::vector<double> correlation = cross_correlation_along_x(earlier, later);
    if (correlation.empty()) return {};
    const auto shifts = static_cast<int>(correlation.size());
    const auto at = [&](int shift) {
        return correlation[static_cast<std::size_t>(((shift % shifts) + shifts) % shifts)];
    };
    const double highest = *std::max_element(correlation.begin(), correlation.end());
    Celerity result;
    result.correlation = highest;
    if (highest < least_correlation) return result;
    const double enough = as_good_as_the_highest * highest;
    const auto is_peak = [&](int shift) {
        return at(shift) >= enough && at(shift) >= at(shift - 1) && at(shift) >= at(shift + 1);
    };
    int nearest = 0;
    while (!is_peak(nearest)) nearest = nearest > 0 ? -nearest : 1 - nearest;
    int shift = nearest;  // noise may have put more than one peak on the same lobe
    for (int s = nearest; s < nearest + shifts && at(s) >= enough; ++s) {
        if (at(s) > at(shift)) shift = s;
    }
    for (int s = nearest; s > nearest - shifts && at(s) >= enough; --s) {
        if (at(s) > at(shift)) shift = s;
    }
    const double sites = shift + peak_offset(at(shift - 1), at(shift), at(shift + 1));
    result.sites_per_step = sites / static_cast<double>(steps);
    result.correlation = at(shift);
    return result;
}

}  // namespace fumon
