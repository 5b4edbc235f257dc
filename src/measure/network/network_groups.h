#pragma once

#include "measure/shared/measure_group.h"

namespace fumon {

/// The channel network of the cells through which at least `channel_area` drains (m², or cells of a
/// bed that is not in metres).
MeasureGroup network_group(const Snapshot& first, double channel_area);

}  // namespace fumon
