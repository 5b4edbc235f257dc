#pragma once

#include <string_view>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// The data that a picture of a run needs and that its beds alone lack ("their water"), or an
/// empty text. `first`: the run's snapshot before its first step.
std::string_view missing_besides_beds(const Snapshot& first, const View& view);

/// Keeps of a snapshot, whose bed is not that of its fields and numbers, only the fields that
/// follow from the bed: the sand on rock, where rock does not wear.
void keep_fields_of_bed(Snapshot& snapshot);

}  // namespace fumon
