#pragma once

#include <cstdint>

#include "base/sha256.h"

namespace fumon {

/// A frame that stands on disk (or went into the movie alone).
struct FrameRecord {
    std::int64_t number = 0;
    std::int64_t step = 0;
    double time = 0.0;
    Sha256 pixels{};
};

}  // namespace fumon
