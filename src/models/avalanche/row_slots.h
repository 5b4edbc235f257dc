#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "models/avalanche/pass_wavefront.h"

namespace fumon {

/// Where rows of a pass are kept between sliding and settling: each in a place of its own, or, for
/// a single pass, in few that stay in the caches, except those along the seams of strips, which
/// wait until all strips are done.
class RowSlots {
  public:
    explicit RowSlots(int rows) : places_(static_cast<std::size_t>(rows)) { take_all(); }

    [[nodiscard]] int of(int y) const { return places_[static_cast<std::size_t>(y)]; }
    [[nodiscard]] bool are_few() const { return few_; }

    void take_all() {
        few_ = false;
        std::iota(places_.begin(), places_.end(), 0);
    }

    /// Takes few where strips have rows enough.
    void take_few(int strips) {
        constexpr int waiting = 3;
        constexpr int moving = 4;
        const auto rows = static_cast<int>(places_.size());
        take_all();
        few_ = rows / strips >= 2 * waiting + moving;
        for (int n = 0; n < strips && few_; ++n) {
            const int begin = PassWavefront::strip_begin(rows, n, strips) + waiting;
            const int end = PassWavefront::strip_begin(rows, n + 1, strips) - waiting;
            for (int y = begin; y < end; ++y)
                places_[static_cast<std::size_t>(y)] = begin + y % moving;
        }
    }

  private:
    std::vector<int> places_;
    bool few_ = false;
};

}  // namespace fumon
