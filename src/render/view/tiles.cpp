#include "render/view/tiles.h"

#include <algorithm>
#include <cmath>

namespace fumon {

namespace {

constexpr int clipped = 128;  // samples: longer than most edges of the terrain's mesh

// Samples: OpenGL works on blocks of pixels (derivatives on 2 × 2 of them), which must be the same
// ones whatever the tile.
constexpr int block = 16;

}  // namespace

int TilePlan::target_begin(int first) const {
    return static_cast<int>(std::floor(static_cast<double>(first - margin) / alignment) *
                            alignment);
}

TilePlan plan_tiles(int width, int height, int factor, int largest) {
    TilePlan plan;
    plan.factor = factor;
    if (width * factor <= largest && height * factor <= largest) {
        plan.tiles.push_back({0, 0, width, height});
        plan.target_width = width * factor;
        plan.target_height = height * factor;
        return plan;
    }
    plan.margin = std::min(clipped, largest / 4);
    plan.alignment = block;
    const int step = std::max((largest - 2 * plan.margin - block) / factor, 1);
    const int step_x = std::min(step, width);
    const int step_y = std::min(step, height);
    for (int y = 0; y < height; y += step_y) {
        for (int x = 0; x < width; x += step_x)
            plan.tiles.push_back({x, y, std::min(step_x, width - x), std::min(step_y, height - y)});
    }
    plan.target_width = step_x * factor + 2 * plan.margin + block;
    plan.target_height = step_y * factor + 2 * plan.margin + block;
    return plan;
}

}  // namespace fumon
