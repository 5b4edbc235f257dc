#pragma once

#include <cstddef>

#include "base/snapshot.h"

namespace fumon {

/// A place among the stored beds of a run: a bed, or between two of them.
struct RecordPlace {
    std::size_t bed = 0;
    std::size_t next = 0;  ///< the bed it goes to; the same where it is none between
    double share = 0.0;    ///< of the way to it, 0 … 1
    friend auto operator<=>(const RecordPlace&, const RecordPlace&) = default;
};

/// What lies between two snapshots of a run, at a share of the time between them: heights, fields
/// and numbers change evenly. Cells without data in one of them have none. Of values that are not
/// finite, of fields that mark cells, of directions and of the air above a bed the nearer
/// snapshot's are taken.
Snapshot blended(const Snapshot& one, const Snapshot& other, double share);

}  // namespace fumon
