#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/truncation.h"
#include "render/view/ground_tiles.h"

namespace fumon {

/// Heights of a periodic bed, or of the maps of a bed in its plain, and their means over squares of
/// 2, 4, 8 … cells.
class HeightPyramid {
  public:
    /// `walls`: whether the bed has walls of rock, see with_straight_walls().
    explicit HeightPyramid(Field<float> heights, const GroundTiles& tiles = {}, bool walls = false);

    [[nodiscard]] const Field<float>& finest() const { return levels_.front(); }
    [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }
    [[nodiscard]] const Field<float>& level(int number) const {
        return levels_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] const GroundTiles& tiles() const { return tiles_; }
    /// Between the four nearest means of a level. `east` and `north` count periods: 0 and 1 are the
    /// two ends of the bed, or of its tile.
    [[nodiscard]] float at(int level, double east, double north) const {
        const Field<float>& field = levels_[static_cast<std::size_t>(level)];
        const glm::dvec2 position = tiles_.in_maps({east, north});
        const LinearTaps x = linear_taps(position.x, field.nx());
        const LinearTaps y = linear_taps(position.y, field.ny());
        const float* below = field.row(y.first).data();
        const float* above = field.row(y.second).data();
        const float south = below[x.first] + x.share * (below[x.second] - below[x.first]);
        const float over = above[x.first] + x.share * (above[x.second] - above[x.first]);
        return south + y.share * (over - south);
    }
    [[nodiscard]] float highest() const { return highest_; }
    [[nodiscard]] bool has_walls() const { return walls_; }

  private:
    struct LinearTaps {
        int first;
        int second;
        float share;  ///< of the second
    };
    static LinearTaps linear_taps(double periods, int count) {
        const double whole = static_cast<double>(truncated(periods));
        double position = (periods - whole) * count - 0.5;
        if (position < 0.0) position += count;
        const int first = truncated_within(position, 0, count - 1);
        return {first, first + 1 == count ? 0 : first + 1, static_cast<float>(position - first)};
    }

    GroundTiles tiles_;
    std::vector<Field<float>> levels_;
    float highest_ = 0.0F;
    bool walls_ = false;
};

}  // namespace fumon
