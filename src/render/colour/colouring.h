#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "render/colour/palette.h"
#include "render/view/display_bed.h"
#include "scene/scene.h"

namespace fumon {

/// Whether the colours mean a quantity of the water: its depth, speed or Froude number.
bool colours_water(Colouring colour_by);

/// Whether the colours mean a field of the run by its name, or its change.
bool colours_field(Colouring colour_by);

/// Whether there may be cells with data, but without a value to colour.
bool leaves_cells_uncoloured(Colouring colour_by);

/// 1 for the cells that have no value to colour: those without data, where the colours mean the
/// water dry ones, and where they mean a field, or its change since `first`, those without a value
/// of it. Empty when all have one.
Mask uncoloured_cells(const LookSettings& look, const Snapshot& snapshot, const Snapshot& first);
/// Likewise, of a field's change only those without a value in the snapshot.
Mask uncoloured_cells(const LookSettings& look, const Snapshot& snapshot);

/// The field that look.field names. Throws InputError, with the names that there are, for another.
const SnapshotField& coloured_field(const LookSettings& look, const Snapshot& snapshot);

/// What is coloured, for every cell of the bed: heights, slopes in degrees (not exaggerated),
/// heights less the first ones, decimal logarithms of the drained areas, a quantity of the water, 0
/// in dry cells, or a field or its change, NaN in cells without a value. Throws InputError for what
/// the snapshot has not.
Field<float> coloured_values(const LookSettings& look, const Snapshot& snapshot,
                             const Snapshot& first);

/// Which share of the values may lie beyond each end of an automatic range; 0: none.
struct RangeTails {
    double low = 0.005;
    double high = 0.005;
};

/// The values at the two ends of the palette, in the unit of what is coloured: model heights
/// (height, change), degrees (slope), m (water-depth), m/s (speed), 1 (froude) or log10 of m² or
/// cells (drainage). What is not fixed by look.low and look.high comes from `values`, the
/// snapshot's coloured_values(): the percentiles of the bed or of the wet cells that `tails` cut
/// off, for slope 0 and the upper percentile, for changes the larger of both on both sides of
/// zero.
/// Natural colouring has the range of height.
std::pair<double, double> colour_range(const LookSettings& look, const Snapshot& snapshot,
                                       const Field<float>& values, const RangeTails& tails = {});

/// The same of several snapshots, at least one, that have one range: the least that holds those of
/// all. A snapshot of one value widens it by that value alone, one without any by nothing.
std::pair<double, double> joined_colour_range(const LookSettings& look,
                                              std::span<const Snapshot> snapshots,
                                              std::span<const Field<float>> values,
                                              const RangeTails& tails = {});

/// Whether look.low or look.high is left to the values that are coloured.
bool ranges_by_values(const LookSettings& look);

/// The colours of a picture: the values at the palette's ends, as colour_range() has them, and
/// whether those of the picture alone would reach further.
struct FrameColourRange {
    double low = 0.0;
    double high = 1.0;
    bool values_below = false;
    bool values_above = false;
    /// They stand for all later pictures too; not before the values of one differ.
    bool kept = false;
};

/// The range of a snapshot, or `former` where that is kept. Where look.range is "frame", a picture
/// has its own, without a word on values beyond. `keeps`: later pictures take the range of this
/// one, if its values differ.
FrameColourRange frame_colour_range(const LookSettings& look, const Snapshot& snapshot,
                                    const Field<float>& values, const FrameColourRange& previous,
                                    bool keeps);

/// The look's palette, the way round that it wants. Throws as read_palette.
Palette chosen_palette(const LookSettings& look);

/// Values as places in the palette, 0 … 65535.
Field<std::uint16_t> palette_coordinates(const Field<float>& values,
                                         std::pair<double, double> range);

/// The field of a snapshot that a marking shows, or nullptr where the model has none.
const SnapshotField* marked_field(Marking mark, const Snapshot& snapshot);

/// A marking's number in shaders/bed/bed.glsl.
float mark_number(Marking mark);

/// How much each cell stands out, 0 … 255: for the last avalanche, cells that toppled fully and
/// cells that only received grains by half. Of the ground, 128 is bare sand, more are plants and
/// less is rock that little or no sand covers. A single 0 when nothing is marked.
Field<std::uint8_t> mark_texels(Marking mark, const Snapshot& snapshot);

}  // namespace fumon
