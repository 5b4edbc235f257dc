#include "measure/bed/slopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "measure/shared/sampled_rank.h"
#include "measure/shared/undefined.h"

namespace fumon {

namespace {

constexpr double level_share = 1e-12;

/// The forward differences of a bed's rows, one row after the other.
class RowDifferences {
  public:
    RowDifferences(const Grid& bed, bool periodic, const Mask& nodata)
        : bed_(bed), periodic_(periodic), nodata_(nodata) {}

    /// Of row y, to `differences`; without those to or from a cell without data.
    void of_row(int y, std::vector<double>& differences) const {
        const auto row = bed_.row(y);
        const std::size_t nx = row.size();
        differences.resize(nx);
        for (std::size_t x = 0; x + 1 < nx; ++x) differences[x] = row[x + 1] - row[x];
        differences[nx - 1] = row.front() - row.back();
        const std::size_t count = periodic_ ? nx : nx - 1;
        if (nodata_.empty()) {
            differences.resize(count);
            return;
        }
        const auto unknown = nodata_.row(y);
        std::size_t known = 0;
        for (std::size_t x = 0; x < count; ++x) {
            const std::size_t next = x + 1 < nx ? x + 1 : 0;
            differences[known] = differences[x];
            known += static_cast<std::size_t>(unknown[x] == 0 && unknown[next] == 0);
        }
        differences.resize(known);
    }

  private:
    const Grid& bed_;
    bool periodic_;
    const Mask& nodata_;
};

/// How many sites rise or fall, by how much in all, and some of them.
struct Side {
    std::size_t count = 0;
    double sum = 0.0;
    std::vector<double> sample;
};

/// The value that nine tenths of a side do not exceed. `each_row` calls its argument with the
/// magnitudes of one row after the other; those that are not of the side lie below all that are.
template <class EachRow>
double ninetieth_percentile(const Side& side, const EachRow& each_row) {
    if (side.count == 0) return undefined;
    const std::size_t rank = (side.count * 9 + 9) / 10 - 1;
    SampledRank values(side.sample, 0.9);
    const auto add_all = [&] {
        std::size_t added = 0;
        each_row([&](std::span<const double> row) {
            values.add(row);
            added += row.size();
        });
        return values.find(added - side.count + rank);
    };
    if (const auto found = add_all()) return *found;
    values.widen();
    return *add_all();
}

/// The sums of both sides. Falls are summed from the last site back.
std::array<Side, 2> sides_of(const RowDifferences& differences, int ny, double level) {
    constexpr std::size_t sampled_sites = 31;  // of which one is of the sample
    std::array<Side, 2> sides;
    Side& rises = sides[0];
    Side& falls = sides[1];
    std::vector<double> forward;
    std::vector<double> backward;
    std::size_t next_sample = 0;
    for (int y = 0; y < ny; ++y) {
        differences.of_row(y, forward);
        differences.of_row(ny - 1 - y, backward);
        const std::size_t count = std::min(forward.size(), backward.size());
        const auto rise = [&](double value) {
            rises.sum += value > level ? value : 0.0;
            rises.count += static_cast<std::size_t>(value > level);
        };
        const auto fall = [&](double value) {
            falls.sum += value < -level ? -value : 0.0;
            falls.count += static_cast<std::size_t>(value < -level);
        };
        for (std::size_t x = 0; x < count; ++x) {  // two sums side by side
            rise(forward[x]);
            fall(backward[backward.size() - 1 - x]);
        }
        for (std::size_t x = count; x < forward.size(); ++x) rise(forward[x]);
        for (std::size_t x = count; x < backward.size(); ++x)
            fall(backward[backward.size() - 1 - x]);
        for (; next_sample < forward.size(); next_sample += sampled_sites) {
            const double value = forward[next_sample];
            if (value > level) rises.sample.push_back(value);
            if (value < -level) falls.sample.push_back(-value);
        }
        next_sample -= forward.size();
    }
    return sides;
}

double mean_of(const Side& side) {
    return side.count == 0 ? undefined : side.sum / static_cast<double>(side.count);
}

double highest_magnitude(const Grid& bed) {
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> highest{};
    const auto values = bed.values();
    std::size_t cell = 0;
    for (; cell + lanes <= values.size(); cell += lanes) {
        for (std::size_t k = 0; k < lanes; ++k)
            highest[k] = std::max(highest[k], std::abs(values[cell + k]));
    }
    for (; cell < values.size(); ++cell) highest[0] = std::max(highest[0], std::abs(values[cell]));
    return *std::max_element(highest.begin(), highest.end());
}

}  // namespace

BedSlopes bed_slopes(const Grid& bed, bool periodic, const Mask& nodata) {
    BedSlopes result;
    if (bed.nx() < 2) return result;
    const double level = level_share * highest_magnitude(bed);
    const RowDifferences differences(bed, periodic, nodata);
    const auto [rises, falls] = sides_of(differences, bed.ny(), level);
    result.stoss = mean_of(rises);
    result.lee = mean_of(falls);
    result.stoss_to_lee = result.stoss / result.lee;
    std::vector<double> row;
    const auto each_row = [&](double sign) {
        return [&, sign](const auto& take) {
            for (int y = 0; y < bed.ny(); ++y) {
                differences.of_row(y, row);
                for (double& value : row) value *= sign;
                take(std::span<const double>(row));
            }
        };
    };
    result.steep_stoss = ninetieth_percentile(rises, each_row(1.0));
    result.steep_lee = ninetieth_percentile(falls, each_row(-1.0));
    return result;
}

}  // namespace fumon
