#pragma once

#include <cstddef>

#include "base/worker_pool.h"

namespace fumon {

/// Calls body(begin, end) over [0, count) on the pool's threads, or on the caller alone where the
/// loop's `numbers` are so few that handing them out would take longer. The bodies' results must
/// not depend on the ranges.
template <class Body>
void over_plane(WorkerPool& pool, int count, std::size_t numbers, const Body& body) {
    constexpr std::size_t least_shared_numbers = 20'000;
    if (numbers < least_shared_numbers) {
        body(0, count);
    } else {
        pool.for_ranges(count, body);
    }
}

}  // namespace fumon
