#include "numerics/prominent_maxima.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace fumon {

namespace {

class SampledLine {
  public:
    SampledLine(std::span<const double> values, bool periodic)
        : values_(values), count_(static_cast<int>(values.size())), periodic_(periodic) {}

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int wrapped(int x) const { return ((x % count_) + count_) % count_; }
    [[nodiscard]] bool has(int x) const { return periodic_ || (x >= 0 && x < count_); }
    [[nodiscard]] double at(int x) const { return values_[static_cast<std::size_t>(wrapped(x))]; }
    [[nodiscard]] double lowest() const { return *std::ranges::min_element(values_); }

    /// The last site of the run of equal values that begins at `first`.
    [[nodiscard]] int end_of_run(int first) const {
        int last = first;
        while (last - first < count_ && has(last + 1) && at(last + 1) == at(first)) ++last;
        return last;
    }

    /// The lowest value between a maximum and higher ground to one side (step ±1); none where there
    /// is no higher ground.
    [[nodiscard]] std::optional<double> saddle(int from, int step, int maximum) const {
        const double top = at(maximum);
        double lowest = top;
        for (int x = from + step, gone = 0; has(x) && gone < count_; x += step, ++gone) {
            const double value = at(x);
            if (value > top || (value == top && lowest < top && wrapped(x) < wrapped(maximum)))
                return lowest;
            lowest = std::min(lowest, value);
        }
        return std::nullopt;
    }

  private:
    std::span<const double> values_;
    int count_;
    bool periodic_;
};

}  // namespace

std::vector<LineMaximum> prominent_maxima(std::span<const double> line, bool periodic,
                                          double least) {
    std::vector<LineMaximum> maxima;
    const SampledLine values(line, periodic);
    if (line.empty() || *std::ranges::max_element(line) == values.lowest()) return maxima;
    for (int first = 0; first < values.count(); ++first) {
        const double top = values.at(first);
        if (values.has(first - 1) && values.at(first - 1) >= top) continue;
        const int last = values.end_of_run(first);
        if (values.has(last + 1) && values.at(last + 1) > top) continue;
        const auto left = values.saddle(first, -1, first);
        const auto right = values.saddle(last, 1, first);
        const double base = left || right ? std::max(left.value_or(values.lowest()),
                                                     right.value_or(values.lowest()))
                                          : values.lowest();
        if (top - base >= least)
            maxima.push_back({values.wrapped((first + last) / 2), top, top - base});
    }
    std::ranges::sort(maxima, {}, &LineMaximum::site);
    return maxima;
}

}  // namespace fumon
