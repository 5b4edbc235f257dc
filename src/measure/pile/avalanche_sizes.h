#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/avalanche.h"

namespace fumon {

/// Cells. No bed has as many.
inline constexpr std::int64_t largest_avalanche = 1'000'000'000'000'000;

/// All avalanches of one size.
struct SizeBin {
    std::int64_t size = 0;   ///< A_s, cells
    std::int64_t count = 0;  ///< A_sn
    double share = 0.0;      ///< A_p = A_sn / A_n (Higashi & Takamori 2003, eq. 6)
};

/// All avalanches of sizes low … high, both included.
struct LogarithmicBin {
    std::int64_t low = 0;   ///< cells
    std::int64_t high = 0;  ///< cells
    std::int64_t count = 0;
    double size = 0.0;     ///< geometric mean of low and high, cells
    double density = 0.0;  ///< count / sizes in the bin / A_n: the mean A_p over its sizes
};

/// How often avalanches of each size came: a histogram of A_s. A_n, by which shares are divided, is
/// the number of avalanches, not of dropped grains or topplings. Memory grows with the number of
/// different sizes only.
class AvalancheSizes {
  public:
    /// Throws Error unless 1 ≤ size ≤ largest_avalanche and count ≥ 0.
    void add(std::int64_t size, std::int64_t count = 1);
    void add(std::span<const Avalanche> avalanches);  ///< likewise
    void add(const AvalancheSizes& others);

    [[nodiscard]] std::int64_t avalanches() const { return avalanches_; }  ///< A_n
    [[nodiscard]] std::int64_t largest() const;  ///< 0 where there is none

    /// Every size that came, the smallest first.
    [[nodiscard]] std::vector<SizeBin> bins() const;

    /// Bins whose edges stand at 10^(k / bins_per_decade), from the smallest size that came to the
    /// largest, empty ones included. Bins too narrow to hold a whole number are left out, so that
    /// the first ones hold one size each. Throws Error unless 1 ≤ bins_per_decade ≤ 100.
    [[nodiscard]] std::vector<LogarithmicBin> logarithmic_bins(int bins_per_decade = 8) const;

  private:
    std::map<std::int64_t, std::int64_t> counts_;
    std::int64_t avalanches_ = 0;
};

}  // namespace fumon
