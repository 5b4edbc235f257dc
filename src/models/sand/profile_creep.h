#pragma once

#include <span>

namespace fumon {

class WorkerPool;

/// Creep of a profile, as in the program of Sudo (2002, appendix, 2-D): in place and from left to
/// right (periodic), each site, as its neighbours then stand,
///
///     strictly higher than both     gives D·h away, half to each
///     else higher than the left     gives E·h to the left
///     else higher than the right    gives E·h to the right
///
/// Reads the profile from `before` (which it uses up) and writes it to `after`; both hold nx
/// heights. With a pool, parts of a long row are swept side by side: each starts from what its left
/// neighbour most likely hands over, and where that was otherwise the sweep is done again until
/// both agree (it never goes far beyond the next trough). The result is the sequential one, bit for
/// bit.
void profile_creep(std::span<double> before, double creep_rate, double flank_rate,
                   std::span<double> after, WorkerPool* pool = nullptr);

}  // namespace fumon
