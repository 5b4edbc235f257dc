#pragma once

#include <cstdint>

namespace fumon {

/// Reserves disk space beyond a file's end without changing its length, so that growing the file by
/// that many bytes cannot fail half-way. Returns 0, or an errno value: ENOSPC, EDQUOT, or EFBIG
/// (also for the process's own limit, `ulimit -f`). File systems that cannot reserve space are
/// trusted to have it and give 0. release_space returns the space.
int reserve_space(int descriptor, std::int64_t bytes);

/// Gives back what lies beyond the file's end.
void release_space(int descriptor);

}  // namespace fumon
