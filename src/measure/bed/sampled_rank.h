#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "measure/bed/row_pass_vectors.h"

namespace fumon {

/// The value of a rank among many, found without an array of them all: a sample tells between
/// which two values it lies almost surely, and of the others only what lies between is kept.
/// Where the sample misled, all are kept: `widen()` and add them again.
class SampledRank {
  public:
    /// How many values a sample needs; of fewer values than some of these, all are kept.
    static constexpr std::size_t least_sample = 2048;

    /// `share` of the values does not exceed the one that is looked for.
    SampledRank(std::vector<double> sample, double share) {
        if (sample.size() < least_sample) return;
        constexpr double margin = 0.02;  // three deviations of a sample's rank, or more
        const auto at = [&](double where) {
            const double last = static_cast<double>(sample.size() - 1);
            const auto place = static_cast<std::ptrdiff_t>(std::clamp(where, 0.0, 1.0) * last);
            std::nth_element(sample.begin(), sample.begin() + place, sample.end());
            return sample[static_cast<std::size_t>(place)];
        };
        if (share - margin > 0.0) low_ = at(share - margin);
        if (share + margin < 1.0) high_ = at(share + margin);
    }

    /// Takes some of the values, which are finite.
    void add(std::span<const double> values) {
        const std::size_t room = count_kept_ + values.size() + row_passes::slack;
        if (kept_.size() < room) kept_.resize(2 * room);
        const row_passes::Kept some =
            row_passes::keep_between(values, low_, high_, kept_.data() + count_kept_);
        count_kept_ += some.count;
        below_ += some.below;
    }

    /// The value that `rank` values lie below or before, where the sample did not mislead.
    [[nodiscard]] std::optional<double> find(std::size_t rank) {
        if (rank < below_ || rank >= below_ + count_kept_) return std::nullopt;
        const auto at = kept_.begin() + static_cast<std::ptrdiff_t>(rank - below_);
        std::nth_element(kept_.begin(), at,
                         kept_.begin() + static_cast<std::ptrdiff_t>(count_kept_));
        return *at;
    }

    /// Keeps all from now on, and begins again.
    void widen() {
        low_ = -std::numeric_limits<double>::infinity();
        high_ = std::numeric_limits<double>::infinity();
        count_kept_ = below_ = 0;
    }

    /// Those that were kept.
    [[nodiscard]] std::span<double> kept() { return std::span(kept_).first(count_kept_); }
    [[nodiscard]] std::size_t below() const { return below_; }

  private:
    double low_ = -std::numeric_limits<double>::infinity();
    double high_ = std::numeric_limits<double>::infinity();
    std::vector<double> kept_;
    std::size_t count_kept_ = 0;
    std::size_t below_ = 0;
};

}  // namespace fumon
