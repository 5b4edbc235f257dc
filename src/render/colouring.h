#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "models/model.h"
#include "render/display_bed.h"
#include "scene/scene.h"

namespace fumon {

/// The values at the two ends of the palette, in the unit of what is coloured: model heights
/// (height, change) or degrees (slope). What is not fixed by look.low and look.high comes from
/// the snapshot: for height the 0.5th and 99.5th percentile of the bed, for slope 0 and the 99.5th
/// percentile, for change the larger of the two tails' 99.5 % on both sides of zero. `first` is
/// the reference of change. Natural colouring has the range of height.
std::pair<double, double> colour_range(const LookSettings& look, const Snapshot& snapshot,
                                       const Snapshot& first);

/// What is coloured, for every cell of the bed: heights, slopes in degrees (not exaggerated), or
/// heights less the first ones.
Field<float> coloured_values(Colouring colour_by, const Snapshot& snapshot, const Snapshot& first);

/// Values as places in the palette, 0 … 65535.
Field<std::uint16_t> palette_places(const Field<float>& values, std::pair<double, double> range);

/// The field of a snapshot that a marking shows, or nullptr where the model has none.
const SnapshotField* marked_field(Marking mark, const Snapshot& snapshot);

/// How much each cell stands out, 0 … 255: for the last avalanche, cells that toppled fully and
/// cells that only received grains by half. A single 0 when nothing is marked.
Field<std::uint8_t> mark_texels(Marking mark, const Snapshot& snapshot);

}  // namespace fumon
