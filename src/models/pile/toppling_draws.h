#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/state_archive.h"
#include "models/pile/sandpile_parameters.h"
#include "models/pile/toppling.h"

namespace fumon {

/// The directions that drop sites, and cells that have none, draw when they topple, and the tosses
/// that decide half steps of the circular mean. Random ones are
/// the numbers of (seed, grain), so that a run can go on from any grain; cycling ones go on from
/// grain to grain.
class TopplingDraws {
  public:
    TopplingDraws(DropDirection kind, std::uint64_t seed)
        : kind_(kind), seed_(seed), stream_(of_grain(0)) {}

    /// The directions of this grain from now on; grain 0 is the settling before the first.
    void begin_grain(std::int64_t grain) { stream_ = of_grain(grain); }

    /// A direction of 1 … 8.
    int draw() {
        ++drawn_;
        if (kind_ == DropDirection::cycling) {
            return static_cast<int>((drawn_ - 1) % direction_count) + 1;
        }
        return static_cast<int>(stream_.below(direction_count)) + 1;
    }

    /// Which way half a step goes: either with equal chance, or in turn where directions cycle.
    HalfStep toss() {
        ++drawn_;
        const bool heads =
            kind_ == DropDirection::cycling ? drawn_ % 2 == 0 : stream_.below(2) == 0;
        return heads ? HalfStep::toward_incoming : HalfStep::toward_previous;
    }

    /// How many have been drawn so far.
    [[nodiscard]] std::int64_t drawn() const { return drawn_; }

    /// Between two grains.
    void serialise(StateArchive& archive) { archive.count("drawn_directions", drawn_); }

  private:
    [[nodiscard]] RandomStream of_grain(std::int64_t grain) const {
        return {seed_, static_cast<std::uint32_t>(grain >> 32), grain,
                Purpose::toppling_directions};
    }

    DropDirection kind_;
    std::uint64_t seed_;
    std::int64_t drawn_ = 0;
    RandomStream stream_;
};

}  // namespace fumon
