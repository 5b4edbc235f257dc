#pragma once

namespace fumon {

/// Water shallower than this, in metres, stands still: it is less than a molecule.
inline constexpr double dry_depth = 1e-10;

}  // namespace fumon
