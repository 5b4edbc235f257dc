#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keys/override.h"

namespace fumon {

/// One thing that a sweep varies: a key, or several that go together, with their values in order.
struct SweepAxis {
    std::string place;              ///< what messages call it: "--over 1"
    std::vector<std::string> keys;  ///< paths; each takes the same value
    std::vector<Override> values;   ///< with the first key's path
};

/// Reads "KEY=V1,V2,…", "KEY=LOW:HIGH:COUNT" or "KEY+KEY=…". Values are read like those of --set; a
/// comma inside quotes or brackets belongs to its value. LOW:HIGH:COUNT are COUNT evenly spaced
/// numbers, both ends included, each the decimal number nearest to the exact one. With `columns`,
/// messages give the column in the text after the place. Throws InputError.
SweepAxis read_axis(const std::string& text, const std::string& place, bool columns = true);

/// The seeds of a sweep, one after the other.
struct SeedRange {
    std::int64_t first = 1;
    std::int64_t last = 1;
    [[nodiscard]] std::int64_t count() const { return last - first + 1; }
};

/// Reads --seeds: "N" is N seeds from `scene_seed` on, "FIRST:LAST" both ends and what lies
/// between. Throws InputError.
SeedRange read_seeds(const std::string& text, std::int64_t scene_seed);

/// How many runs a sweep may have.
inline constexpr std::int64_t most_runs = 100'000;

}  // namespace fumon
