#pragma once

#include <glm/glm.hpp>

#include "render/view/block.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// How endless ground stands at a point: where on the bed it is taken from, and how high.
struct WarpedGround {
    glm::dvec2 offset{0.0};    ///< to where it is taken from, periods
    glm::dmat2 jacobian{1.0};  ///< how that point moves on, of a way over the ground; periods
    double height = 1.0;       ///< of the bed's, counted from its mean
    glm::dvec2 height_gradient{0.0};  ///< how that changes on the way, per period
};

/// Endless ground of a bed that repeats, whose copies far away are made unlike each other: each
/// takes its ground from a point somewhat aside, so that it is wider or narrower than the bed, and
/// stands lower, so that no slope grows by more than a twentieth. Two sets of waves,
/// incommensurate with the period, give the offset: short ones make neighbours differ, long ones
/// bend rows. The warp is fixed to the ground, not to a camera that moves over it.
class TileWarp {
  public:
    TileWarp() = default;  ///< all alike
    /// For ground that a camera sees first: what it looks at is as it is on the bed, and where it
    /// stands if that is no farther than a period. `bed`: the first one, as it is shown. Copies of
    /// one with many landforms differ less.
    TileWarp(const Camera& first, const Block& block, const Snapshot& bed);

    [[nodiscard]] bool varied() const { return strength_ > 0.0; }
    /// How far they are, 0 … 1.
    [[nodiscard]] double strength() const { return strength_; }
    /// Whether ground there may be other than the bed's.
    [[nodiscard]] bool varies_at(const glm::dvec2& position) const;
    /// Of a point from the bed's middle, block lengths.
    [[nodiscard]] WarpedGround at(const glm::dvec2& position) const;
    /// The point on the bed that a point on the ground shows, both block lengths from the bed's
    /// middle; and the point on the ground that shows one of the bed or of its repetitions.
    [[nodiscard]] glm::dvec2 bed_position_at(const glm::dvec2& position) const;
    [[nodiscard]] glm::dvec2 ground_position_of(const glm::dvec2& shown) const;
    /// How high ground of a copy stands that stands at `z` on the bed, block lengths.
    [[nodiscard]] double raised(const WarpedGround& copy, double z) const {
        return mean_ + copy.height * (z - mean_);
    }
    /// Its slope, of the bed's there.
    [[nodiscard]] glm::dvec2 slope(const WarpedGround& copy, const glm::dvec2& on_bed,
                                   double z) const;
    /// Of a point that lies `within` periods aside of `origin`, a cell's corner as `share` of the
    /// bed's sides: periods from the middle of what is as it is. The same bits for a bed shifted by
    /// whole cells with its cameras.
    [[nodiscard]] glm::dvec2 from_middle(const glm::dvec2& share, const glm::dvec2& within) const;
    /// z of the bed's mean, block lengths.
    [[nodiscard]] double mean() const { return mean_; }

  private:
    double strength_ = 0.0;
    glm::dvec2 middle_{0.0};  ///< of what is as it is, periods from the bed's
    glm::dvec2 extent_{1.0};
    glm::dvec2 cells_{1.0};
    double mean_ = 0.0;
};

/// Whether those of a view are, of a bed that repeats or not.
bool tiles_are_warped(const View& view, bool repeats);

/// Those of a view, from the first camera of its pictures; `first` as it is shown.
TileWarp tile_warp_of(const View& view, const Block& block, const Snapshot& first);

}  // namespace fumon
