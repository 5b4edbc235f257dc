#pragma once

#include <cstdint>

namespace fumon {

/// All toppling that one dropped grain sets off (Higashi & Takamori 2003, section 4.2).
struct Avalanche {
    std::int64_t grain = 0;      ///< the grain that set it off, counted from 1
    std::int64_t size = 0;       ///< A_s: distinct cells whose height changed
    std::int64_t duration = 0;   ///< rounds of toppling until rest
    std::int64_t topplings = 0;  ///< cells that toppled, each as often as it did
    std::int64_t lost = 0;       ///< grains that left over the edge
};

}  // namespace fumon
