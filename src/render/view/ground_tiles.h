#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace fumon {

/// How the maps of endless ground are laid over it. A bed that repeats has maps of one period. One
/// that ends lies in the middle of a tile that goes on as a plain; its maps hold that tile and,
/// east of it, one of the plain alone, whose edges are the same.
struct GroundTiles {
    bool plain = false;  ///< whether there is one

    [[nodiscard]] int count() const { return plain ? 2 : 1; }

    /// The place in the maps, 0 … 1 from one of their ends to the other, of one that counts tiles
    /// from the south-western corner of the bed's own; without a plain the same again.
    [[nodiscard]] glm::dvec2 in_maps(const glm::dvec2& tiles) const {
        if (!plain) return tiles;
        const glm::dvec2 whole = glm::floor(tiles);
        const bool own = whole.x == 0.0 && whole.y == 0.0;
        return {0.5 * (tiles.x - whole.x + (own ? 0.0 : 1.0)), tiles.y - whole.y};
    }
};

}  // namespace fumon
