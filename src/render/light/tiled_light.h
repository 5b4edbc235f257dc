#pragma once

#include <functional>

#include "base/grid.h"
#include "render/view/ground_tiles.h"

namespace fumon {

/// Shares of light over the maps of endless ground, of its heights. `repeated` finds them for
/// heights that repeat. `open` finds them for a bed's tile: of heights with a margin of so many
/// cells on each side, without that margin; near the edges of its tile, which are those of the
/// plain, what the bed throws on the plain fades out.
Field<float> shares_over_tiles(
    const Field<float>& heights, const GroundTiles& tiles,
    const std::function<Field<float>(const Field<float>&)>& repeated,
    const std::function<Field<float>(const Field<float>&, int margin)>& open);

}  // namespace fumon
