#pragma once

#include <span>

#include "measure/shared/measure_group.h"

namespace fumon {

/// The numbers that a model keeps itself, as the first snapshot has them, but for those named.
MeasureGroup number_group(const Snapshot& first, std::span<const MeasureColumn> taken);

}  // namespace fumon
