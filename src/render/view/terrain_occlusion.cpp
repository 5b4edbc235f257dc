#include "render/view/terrain_occlusion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fumon {

TerrainOcclusion::TerrainOcclusion(const Snapshot& snapshot, const Block& block,
                                   const Camera& camera)
    : snapshot_(snapshot),
      block_(block),
      camera_(camera),
      cells_(snapshot.bed.nx() / block.width_x, snapshot.bed.ny() / block.width_y) {
    highest_ = block.z(*std::ranges::max_element(snapshot.bed.values()));
}

glm::dvec3 TerrainOcclusion::point(const glm::dvec2& cell) const {
    return {(cell.x + 0.5) / cells_.x - 0.5 * block_.width_x,
            (cell.y + 0.5) / cells_.y - 0.5 * block_.width_y, z(cell)};
}

bool TerrainOcclusion::visible(const glm::dvec2& cell) const {
    const glm::dvec3 from = point(cell);
    if (camera_.perspective && glm::dot(from - camera_.eye, camera_.forward) < camera_.near_depth)
        return false;
    const glm::dvec3 towards = camera_.perspective ? camera_.eye - from : -camera_.forward;
    const glm::dvec3 in_cells(towards.x * cells_.x, towards.y * cells_.y, towards.z);
    const double level = glm::length(glm::dvec2(in_cells));
    if (level < 1e-9) return true;
    const glm::dvec3 step = in_cells * (0.5 / level);
    const double most = camera_.perspective ? 2.0 * level : 1e9;
    const double slack = 0.03 / std::max(cells_.x, cells_.y);
    for (double k = 2.0; k < most; k += 1.0) {
        const glm::dvec2 here = cell + k * glm::dvec2(step);
        const double height = from.z + k * step.z;
        if (height > highest_ || !inside(here)) return true;
        if (z(here) > height + slack) return false;
    }
    return true;
}

bool TerrainOcclusion::inside(const glm::dvec2& cell) const {
    return cell.x >= -0.5 && cell.y >= -0.5 && cell.x <= snapshot_.bed.nx() - 0.5 &&
           cell.y <= snapshot_.bed.ny() - 0.5;
}

/// Of the bed, linear between cells.
double TerrainOcclusion::z(const glm::dvec2& cell) const {
    const Grid& bed = snapshot_.bed;
    const auto split = [](double position, int count) {
        const double within = std::clamp(position, 0.0, count - 1.0);
        const int low = std::min(static_cast<int>(within), std::max(count - 2, 0));
        return std::pair(low, within - low);
    };
    const auto [x, s] = split(cell.x, bed.nx());
    const auto [y, t] = split(cell.y, bed.ny());
    const int east = std::min(x + 1, bed.nx() - 1);
    const int north = std::min(y + 1, bed.ny() - 1);
    return block_.z(std::lerp(std::lerp(bed(x, y), bed(east, y), s),
                              std::lerp(bed(x, north), bed(east, north), s), t));
}

}  // namespace fumon
