#pragma once

#include <string_view>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// What a picture of a run needs beside its beds and these alone do not tell ("their water"), or
/// nothing. `first`: the run's snapshot before its first step.
std::string_view missing_besides_beds(const Snapshot& first, const View& view);

/// Leaves a snapshot, whose bed is another than that of its fields and numbers, what its bed tells:
/// the sand that lies on rock, where rock does not wear. The rest goes.
void keep_fields_of_bed(Snapshot& snapshot);

}  // namespace fumon
