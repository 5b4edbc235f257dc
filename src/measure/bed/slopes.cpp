#include "measure/bed/slopes.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "measure/bed/row_pass_vectors.h"
#include "measure/bed/sampled_rank.h"
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
        row_passes::differences(row, differences.data());
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

constexpr double steep_share = 0.9;

/// The sites that rise, or those that fall: how many, by how much in all, and the magnitude that
/// nine tenths do not exceed.
class Side {
  public:
    Side(double sign, double level, std::vector<double> sample)
        : sign_(sign), level_(level), ranks_(std::move(sample), steep_share) {}

    /// Takes those of a row's differences that are of the side, whose magnitudes are then
    /// `latest`.
    void take(std::span<const double> differences) {
        kept_.resize(differences.size() + row_passes::slack);
        latest_ = std::span(kept_).first(
            row_passes::keep_above(differences, sign_, level_, kept_.data()));
        count_ += latest_.size();
        ranks_.add(latest_);
    }
    [[nodiscard]] std::span<const double> latest() const { return latest_; }
    [[nodiscard]] std::size_t count() const { return count_; }

    /// Undefined of no site; nothing where the sample misled: then all are to be taken again.
    std::optional<double> steep() {
        if (count_ == 0) return undefined;
        return ranks_.find((count_ * 9 + 9) / 10 - 1);
    }
    void begin_again() {
        count_ = 0;
        ranks_.widen();
    }

  private:
    double sign_;
    double level_;
    SampledRank ranks_;
    std::vector<double> kept_;
    std::span<const double> latest_;
    std::size_t count_ = 0;
};

/// Adds rises from the first and falls from the last on, two sums side by side.
void add_both(std::span<const double> rises, std::span<const double> falls, double& rise,
              double& fall) {
    const std::size_t count = std::min(rises.size(), falls.size());
    for (std::size_t i = 0; i < count; ++i) {
        rise += rises[i];
        fall += falls[falls.size() - 1 - i];
    }
    for (std::size_t i = count; i < rises.size(); ++i) rise += rises[i];
    for (std::size_t i = count; i < falls.size(); ++i) fall += falls[falls.size() - 1 - i];
}

/// A side without any site yet. What its ranks are sought by is a sample of the sites.
Side side_of(const Grid& bed, double sign, double level) {
    constexpr std::size_t sampled_sites = 31;  // of which one is of the sample
    std::vector<double> sample;
    const auto heights = bed.values();
    const auto nx = static_cast<std::size_t>(bed.nx());
    for (std::size_t cell = 0; cell + 1 < heights.size(); cell += sampled_sites) {
        if ((cell + 1) % nx == 0) continue;
        const double value = sign * (heights[cell + 1] - heights[cell]);
        if (value > level) sample.push_back(value);
    }
    return {sign, level, std::move(sample)};
}

double mean_of(double sum, const Side& side) {
    return side.count() == 0 ? undefined : sum / static_cast<double>(side.count());
}

double highest_magnitude(const Grid& bed) {
    return row_passes::highest_magnitude(bed.values());
}

}  // namespace

BedSlopes bed_slopes(const Grid& bed, bool periodic, const Mask& nodata) {
    BedSlopes result;
    if (bed.nx() < 2) return result;
    const double level = level_share * highest_magnitude(bed);
    const RowDifferences differences(bed, periodic, nodata);
    Side rises = side_of(bed, 1.0, level);
    Side falls = side_of(bed, -1.0, level);
    std::vector<double> row;
    double rise = 0.0;
    double fall = 0.0;
    const auto take_all = [&] {
        rise = fall = 0.0;
        for (int y = 0; y < bed.ny(); ++y) {
            differences.of_row(y, row);
            rises.take(row);
            differences.of_row(bed.ny() - 1 - y, row);
            falls.take(row);
            add_both(rises.latest(), falls.latest(), rise, fall);
        }
    };
    take_all();
    if (!rises.steep() || !falls.steep()) {
        rises.begin_again();
        falls.begin_again();
        take_all();
    }
    result.stoss = mean_of(rise, rises);
    result.lee = mean_of(fall, falls);
    result.stoss_to_lee = result.stoss / result.lee;
    result.steep_stoss = *rises.steep();
    result.steep_lee = *falls.steep();
    return result;
}

}  // namespace fumon
