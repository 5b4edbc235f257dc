#pragma once

#include <cstdint>

namespace fumon::test {

/// What the preloaded library tells of a program's requests for memory.
struct MemoryReport {
    std::int64_t requests = 0;
    std::int64_t failed = 0;  ///< 1: one was made to fail
};

}  // namespace fumon::test
