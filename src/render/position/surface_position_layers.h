#pragma once

#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "base/grid.h"
#include "base/image.h"
#include "base/snapshot.h"
#include "render/view/block.h"
#include "render/view/camera.h"
#include "render/view/tile_warp.h"
#include "render/view/tiles.h"

namespace fumon {

class WorkerPool;

/// The drawn ground, as SurfacePositionLayers needs it.
struct DrawnGround {
    const Snapshot& snapshot;
    const Block& block;
    Block ground;  ///< of endless ground's maps, else the same
    const Camera& camera;
    Field<float> surface;  ///< as it is drawn, water included, block lengths
    TileWarp copies;       ///< of endless ground
    bool endless = false;  ///< repeated to the horizon; points are then offsets from the eye
    bool plain = false;    ///< whether a plain lies around the block's foot
};

/// Geometry layers of a picture: the surface point at the middle of each pixel, as drawn, with
/// heights times the vertical exaggeration. Lengths are metres, or sites where the bed is not in
/// metres:
///     Z               distance along the view axis; infinite where nothing is seen
///     normal.X Y Z    unit vector, of the bed that of its surface between the cells; 0 if nothing
///     position.X Y Z  east and north of the bed's south-western corner, and above height 0
///     field.NAME      of the cell that is seen: "height" and the snapshot's fields, without
///                     exaggeration; not a number beside the bed
class SurfacePositionLayers {
  public:
    SurfacePositionLayers(int width, int height, DrawnGround ground);

    /// `visibility`: what position/position.frag.glsl or world/world_visibility.frag.glsl wrote of
    /// a tile, the lowest row first.
    void add(const Tile& tile, const std::vector<float>& seen, WorkerPool& pool);

    [[nodiscard]] std::vector<ImageLayer> take() { return std::move(layers_); }

  private:
    struct SurfacePoint {
        bool anything = false;
        bool bed = false;
        glm::dvec3 point{0.0};
        glm::dvec3 normal{0.0};
    };
    [[nodiscard]] SurfacePoint surface_point_at(int x, int y, const float* texel) const;
    [[nodiscard]] glm::dvec3 surface_normal(const glm::dvec2& share) const;
    /// The same of a far copy at a point from the bed's middle.
    [[nodiscard]] glm::dvec3 copy_normal(const glm::dvec2& position) const;
    [[nodiscard]] bool beside_bed(double east, double north) const;
    void put(std::size_t pixel, const SurfacePoint& seen);

    int width_;
    int height_;
    DrawnGround ground_;
    std::vector<const Grid*> fields_;
    std::vector<double> scales_;  ///< of the fields
    std::vector<ImageLayer> layers_;
};

/// World to camera and to the picture, for the lengths of these layers; see LayeredImage.
void set_matrices(LayeredImage& image, const Block& block, const Camera& camera);

}  // namespace fumon
