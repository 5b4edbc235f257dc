#include "measure/pile/avalanche_sizes.h"

#include <fmt/format.h>

#include <cmath>

#include "base/elementary_power.h"
#include "base/error.h"

namespace fumon {

namespace {

constexpr double ten = 10.0;

/// The smallest whole numbers at or above 10^(k / bins_per_decade), k = 0, 1, … Whole powers of ten
/// are exact; no other edge is a whole number.
class Edges {
  public:
    explicit Edges(int bins_per_decade) : bins_(bins_per_decade) {}

    /// The next edge above the last one. Ends where integers do: not to be asked for edges beyond
    /// the first one above `largest_avalanche`.
    std::int64_t next() {
        const std::int64_t last = edge_;
        while (edge_ == last) {
            edge_ = static_cast<std::int64_t>(std::ceil(
                step_ == 0 ? decade_
                           : decade_ * elementary::pow(ten, static_cast<double>(step_) / bins_)));
            if (++step_ == bins_) {
                step_ = 0;
                decade_ *= ten;
            }
        }
        return edge_;
    }

  private:
    int bins_;
    int step_ = 0;
    double decade_ = 1.0;
    std::int64_t edge_ = 0;
};

}  // namespace

void AvalancheSizes::add(std::int64_t size, std::int64_t count) {
    if (size < 1 || size > largest_avalanche)
        throw Error(
            fmt::format("an avalanche has from 1 to {} cells, not {}", largest_avalanche, size));
    if (count < 0) throw Error(fmt::format("{} avalanches cannot be counted", count));
    if (count == 0) return;
    counts_[size] += count;
    avalanches_ += count;
}

void AvalancheSizes::add(std::span<const Avalanche> avalanches) {
    for (const Avalanche& avalanche : avalanches) add(avalanche.size);
}

void AvalancheSizes::add(const AvalancheSizes& others) {
    const auto added = others.counts_;  // a copy: one may add sizes to themselves
    for (const auto& [size, count] : added) add(size, count);
}

std::int64_t AvalancheSizes::largest() const {
    return counts_.empty() ? 0 : counts_.rbegin()->first;
}

std::vector<SizeBin> AvalancheSizes::bins() const {
    std::vector<SizeBin> bins;
    bins.reserve(counts_.size());
    for (const auto& [size, count] : counts_)
        bins.push_back(
            {size, count, static_cast<double>(count) / static_cast<double>(avalanches_)});
    return bins;
}

std::vector<LogarithmicBin> AvalancheSizes::logarithmic_bins(int bins_per_decade) const {
    constexpr int most = 100;
    if (bins_per_decade < 1 || bins_per_decade > most)
        throw Error(
            fmt::format("{} bins a decade; from 1 to {} are possible", bins_per_decade, most));
    std::vector<LogarithmicBin> bins;
    Edges edges(bins_per_decade);
    std::int64_t low = edges.next();
    auto counted = counts_.begin();
    while (counted != counts_.end()) {
        const std::int64_t end = edges.next();
        LogarithmicBin bin;
        bin.low = low;
        bin.high = end - 1;
        for (; counted != counts_.end() && counted->first < end; ++counted)
            bin.count += counted->second;
        low = end;
        if (bins.empty() && bin.count == 0) continue;
        bin.size = std::sqrt(static_cast<double>(bin.low) * static_cast<double>(bin.high));
        bin.density = static_cast<double>(bin.count) / static_cast<double>(bin.high - bin.low + 1) /
                      static_cast<double>(avalanches_);
        bins.push_back(bin);
    }
    return bins;
}

}  // namespace fumon
