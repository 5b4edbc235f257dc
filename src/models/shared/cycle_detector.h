#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fumon {

/// Detects a pile that will never come to rest. The published rule moves grains along a cell's
/// direction even where that is uphill, so a ring of cells beside a deep hole can hand grains round
/// for ever (seen on rough beds, most of all with one grain per topple). Toppling without random
/// draws is deterministic: a pile that returns to an earlier state repeats itself for ever.
class CycleDetector {
  public:
    /// To be called between two rounds of toppling, with everything the next round depends on: the
    /// cells that the avalanche has changed, all packed cells, and the queue if there is one.
    /// States are compared by a 64-bit digest with the one at the last power of two (Brent 1980),
    /// not before many topplings a cell, and so seldom that the cost is below one cell a topple.
    /// Throws Error where the state is one that has been.
    void observe(std::int64_t topplings, std::int64_t draws, std::span<const std::size_t> changed,
                 std::span<const std::int32_t> cells, std::span<const std::size_t> queue) {
        const auto size = static_cast<std::int64_t>(changed.size());
        if (topplings - topplings_at_last_check_ > topplings_per_cell * size)
            compare(topplings, draws, changed, cells, queue);
    }

  private:
    static constexpr std::int64_t topplings_per_cell = 64;

    void compare(std::int64_t topplings, std::int64_t draws, std::span<const std::size_t> changed,
                 std::span<const std::int32_t> cells, std::span<const std::size_t> queue);

    std::int64_t topplings_at_last_check_ = 0;
    std::int64_t checks_ = 0;
    std::int64_t next_reference_ = 1;
    std::uint64_t reference_digest_ = 0;
    std::int64_t reference_draws_ = -1;
};

}  // namespace fumon
