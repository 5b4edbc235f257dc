#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/image.h"
#include "render/background/background_layer.h"
#include "render/samples/packed_samples.h"
#include "render/samples/resolve_vectors.h"
#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// What tiles of 8 bits a channel come to. The surroundings of the last one stay until others are
/// read.
class BytePicture {
  public:
    /// Reads the bound target, of a tile's surroundings.
    void read_background(const Tile& tile, RowOrder order);
    /// Reads the bound target of samples, whose first of this tile is `from`, into the picture.
    void resolve(const Tile& tile, int factor, const glm::ivec2& from, WorkerPool& pool,
                 Image& image);
    /// Puts a tile's pixels of endless ground into the picture.
    void resolve(const Tile& tile, int factor, const PackedSamples& samples, WorkerPool& pool,
                 Image& image) const;
    /// Rows of the surroundings, the upper first.
    [[nodiscard]] const std::vector<ColourPlanes>& behind() const { return behind_; }

  private:
    /// Takes a row of the tile, counted from the upper one, whose samples have been added.
    void finish(const Tile& tile, int y, RowResolver& row, Image& image) const;

    std::vector<ColourPlanes> behind_;         // rows of the surroundings, the upper first
    std::vector<std::uint32_t> samples_read_;  // those of a few rows of pixels
};

}  // namespace fumon
