#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>

#include "base/snapshot.h"
#include "figure/layers/seen_layers.h"
#include "figure/panels/ground_axes.h"
#include "render/view/terrain_occlusion.h"

namespace fumon {

/// A snapshot's ground, as it is shown, where a camera sees it; both outlive it. Nothing lies on
/// cells without data.
class ProjectedGround : public GroundSight {
  public:
    ProjectedGround(const Snapshot& shown, const ViewProjection& view)
        : view_(view),
          nodata_(shown.nodata),
          rimmed_(rimmed(shown)),
          ground_(nodata_.empty() ? shown : rimmed_, view.block, view.camera),
          cells_(shown.bed.nx(), shown.bed.ny()) {}

    [[nodiscard]] std::optional<CanvasPoint> at(const BedPlace& place) const override {
        if (!nodata_.empty()) {
            const glm::ivec2 cell = glm::clamp(glm::ivec2(glm::dvec2(place[0], place[1]) * cells_),
                                               glm::ivec2(0), glm::ivec2(cells_) - 1);
            if (nodata_(cell.x, cell.y) != 0) return std::nullopt;
        }
        const glm::dvec3 point = ground_.point(cell_of(place));
        const Camera& camera = view_.camera;
        if (camera.perspective && glm::dot(point - camera.eye, camera.forward) < camera.near_depth)
            return std::nullopt;
        return view_.at(point);
    }
    [[nodiscard]] bool visible(const BedPlace& place) const override {
        return ground_.visible(cell_of(place));
    }

  private:
    /// The bed where cells without data beside others have the mean of these, so that ground
    /// between cells is as high as these; nothing where all have data.
    static Snapshot rimmed(const Snapshot& shown) {
        Snapshot rim;
        if (shown.nodata.empty()) return rim;
        rim.bed = shown.bed;
        for (int y = 0; y < rim.bed.ny(); ++y) {
            for (int x = 0; x < rim.bed.nx(); ++x) {
                if (shown.nodata(x, y) != 0) rim.bed(x, y) = mean_around(shown, x, y);
            }
        }
        return rim;
    }

    static double mean_around(const Snapshot& shown, int x, int y) {
        double sum = 0.0;
        int count = 0;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, shown.bed.ny() - 1); ++j) {
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, shown.bed.nx() - 1); ++i) {
                if (shown.nodata(i, j) != 0) continue;
                sum += shown.bed(i, j);
                ++count;
            }
        }
        return count > 0 ? sum / count : shown.bed(x, y);
    }

    [[nodiscard]] glm::dvec2 cell_of(const BedPlace& place) const {
        return glm::dvec2(place[0], place[1]) * cells_ - 0.5;
    }

    const ViewProjection& view_;
    const Mask& nodata_;
    Snapshot rimmed_;
    TerrainOcclusion ground_;
    glm::dvec2 cells_;
};

}  // namespace fumon
