#pragma once

#include "base/snapshot.h"

namespace fumon {

/// Lets still water stand over ground below a level (m, in the bed's heights) that hangs together
/// with the bed's edge below it: the outermost cells, and those beside cells without data. Water
/// that is deeper there stays as it is, a hollow inland stays dry. All beds of a run get the fields
/// of water, also those that lie over the level. False for a periodic bed, which has no edge and
/// stays as it is. Only for pictures: no model knows of this water.
bool add_sea(Snapshot& snapshot, double level);

}  // namespace fumon
