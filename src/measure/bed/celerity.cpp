#include "measure/bed/celerity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "measure/bed/bed_along_wind.h"
#include "numerics/peak_offset.h"

namespace fumon {

namespace {

constexpr double least_correlation = 0.3;
constexpr double comparable_peak_share = 0.8;

/// The displacement at the peak of correlations at shifts of 0, 1, 2 …, of which the second half
/// are negative ones.
Celerity celerity_of(const std::vector<double>& correlation, std::int64_t steps) {
    if (correlation.empty()) return {};
    const auto shifts = static_cast<int>(correlation.size());
    const auto at = [&](int shift) {
        return correlation[static_cast<std::size_t>(((shift % shifts) + shifts) % shifts)];
    };
    const double highest = *std::max_element(correlation.begin(), correlation.end());
    Celerity result;
    result.correlation = highest;
    if (highest < least_correlation) return result;
    const double enough = comparable_peak_share * highest;
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

/// The row of a periodic bed that begins at a place between cells, linear between them.
void row_between(const Grid& bed, double east, double north, std::vector<double>& values) {
    const auto round = [](double place, int count) {
        return place - count * std::floor(place / count);
    };
    const double y = round(north, bed.ny());
    const double x = round(east, bed.nx());
    const int south = std::min(static_cast<int>(y), bed.ny() - 1);
    const auto lower = bed.row(south);
    const auto upper = bed.row((south + 1) % bed.ny());
    const double up = y - south;
    const auto count = static_cast<std::size_t>(bed.nx());
    const auto first = std::min(static_cast<std::size_t>(x), count - 1);
    const double right = x - static_cast<double>(first);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t here = first + i < count ? first + i : first + i - count;
        const std::size_t next = here + 1 < count ? here + 1 : 0;
        values[i] = (1.0 - up) * ((1.0 - right) * lower[here] + right * lower[next]) +
                    up * ((1.0 - right) * upper[here] + right * upper[next]);
    }
}

double mean_of(const Grid& bed) {
    double sum = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        double of_row = 0.0;
        for (const double height : bed.row(y)) of_row += height;
        sum += of_row / bed.nx();
    }
    return sum / bed.ny();
}

/// Correlations of a bed with itself later, displaced by 0, 1, 2 … sites along `direction` and
/// back: over as many of its rows as keep the work within bounds.
std::vector<double> correlations_along(const Snapshot& earlier, const Snapshot& later,
                                       const HorizontalDirection& direction) {
    constexpr double most_work = 3e7;  // products
    const Grid& before = earlier.bed;
    const double cell_aspect = later.scale.dy / later.scale.dx;
    const int reach = before.nx() / 2;
    const double work = static_cast<double>(before.size()) * (2.0 * reach + 1.0);
    const int every = 1 + static_cast<int>(work / most_work);
    const double mean_before = mean_of(before);
    const double mean_after = mean_of(later.bed);
    std::vector<double> correlations(2 * static_cast<std::size_t>(reach) + 1);
    const auto place = [&](int shift) {
        return static_cast<std::size_t>(shift < 0 ? shift + 2 * reach + 1 : shift);
    };
    double squares_before = 0.0;
    double squares_after = 0.0;
    std::vector<double> moved(static_cast<std::size_t>(before.nx()));
    for (int y = 0; y < before.ny(); y += every) {
        const auto row = before.row(y);
        for (int shift = -reach; shift <= reach; ++shift) {
            const double east = shift * direction.x;
            const double north = y + shift * direction.y / cell_aspect;
            row_between(later.bed, east, north, moved);
            double product = 0.0;
            for (std::size_t x = 0; x < row.size(); ++x)
                product += (row[x] - mean_before) * (moved[x] - mean_after);
            correlations[place(shift)] += product;
            if (shift != 0) continue;
            for (std::size_t x = 0; x < row.size(); ++x) {
                squares_before += (row[x] - mean_before) * (row[x] - mean_before);
                squares_after += (moved[x] - mean_after) * (moved[x] - mean_after);
            }
        }
    }
    const double whole = std::sqrt(squares_before * squares_after);
    if (!(whole > 0.0)) return {};
    for (double& value : correlations) value /= whole;
    return correlations;
}

}  // namespace

Celerity celerity_along_x(const Grid& earlier, const Grid& later, std::int64_t steps) {
    if (steps < 1) throw Error("a celerity needs two snapshots at least one step apart");
    return celerity_of(cross_correlation_along_x(earlier, later), steps);
}

Celerity celerity_of_spectra(const RowSpectra& earlier, const RowSpectra& later,
                             std::int64_t steps) {
    return celerity_of(cross_correlation(earlier, later), steps);
}

Celerity celerity_along(const Snapshot& earlier, const Snapshot& later,
                        const HorizontalDirection& direction) {
    const std::int64_t steps = later.step - earlier.step;
    const bool square = later.scale.dx == later.scale.dy;
    if (direction.y == 0.0 || (direction.x == 0.0 && square))
        return celerity_along_x(bed_along_wind(earlier, direction).bed,
                                bed_along_wind(later, direction).bed, steps);
    if (steps < 1) throw Error("a celerity needs two snapshots at least one step apart");
    return celerity_of(correlations_along(earlier, later, direction), steps);
}

}  // namespace fumon
