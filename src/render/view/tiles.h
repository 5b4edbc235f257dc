#pragma once

#include <vector>

namespace fumon {

/// A part of a picture that is drawn at once, in pixels; y counts rows from the top.
struct Tile {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// How a picture is cut, and the samples each tile is drawn with.
struct TilePlan {
    std::vector<Tile> tiles;
    int factor = 1;        ///< samples along each side of a pixel
    int margin = 0;        ///< samples drawn around a tile and thrown away, where triangles are cut
    int alignment = 1;     ///< tiles begin at multiples of this many samples
    int target_width = 0;  ///< samples
    int target_height = 0;

    /// The sample, from the picture's lower left, at which the target of a tile begins whose first
    /// one is `first`: along either side.
    [[nodiscard]] int target_begin(int first) const;
};

/// One tile where the supersampled picture has at most `largest` samples on each side, else tiles
/// of at most that many with a margin of `clipped` samples.
TilePlan plan_tiles(int width, int height, int factor, int largest);

}  // namespace fumon
