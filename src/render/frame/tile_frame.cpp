#include "render/frame/tile_frame.h"

namespace fumon {

glm::ivec2 TileFrame::picture() const {
    return {static_cast<int>(view.image.width), static_cast<int>(view.image.height)};
}

int TileFrame::rows_below() const {
    return static_cast<int>(view.image.height) - tile.y - tile.height;
}

glm::ivec2 TileFrame::first_sample() const {
    return glm::ivec2(tile.x, rows_below()) * plan.factor;
}

glm::ivec2 TileFrame::target_corner() const {
    const glm::ivec2 first = first_sample();
    return {plan.target_begin(first.x), plan.target_begin(first.y)};
}

TileSamples TileFrame::samples() const {
    return {glm::vec2(picture()) * static_cast<float>(plan.factor), glm::vec2(target_corner()),
            glm::vec2(glm::ivec2(plan.target_width, plan.target_height))};
}

TileSamples TileFrame::pixels(const glm::ivec2& target_size) const {
    return {glm::vec2(picture()), glm::vec2(glm::ivec2(tile.x, rows_below())),
            glm::vec2(target_size)};
}

}  // namespace fumon
