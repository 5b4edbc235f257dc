#pragma once

#include <cstdint>

namespace fumon {

/// Sets disk space aside beyond a file's end, without changing its length, so that growing by that
/// many bytes cannot fail half-way. Returns 0, or the errno value of what is in the way: ENOSPC,
/// EDQUOT, or EFBIG (the process's own limit, `ulimit -f`, too). File systems that cannot set space
/// aside are trusted to have it: 0. The space goes back by release_space.
int reserve_space(int descriptor, std::int64_t bytes);

/// Gives back what lies beyond the file's end.
void release_space(int descriptor);

}  // namespace fumon
