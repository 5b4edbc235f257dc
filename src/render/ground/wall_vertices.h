#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fumon {

/// A point along a ray.
struct RaySample {
    double radius = 0.0;
    double over = 0.0;     ///< the eye
    double tangent = 0.0;  ///< of its elevation
};

/// The points that stand for the rings along a ray over a bed with walls. The point that looks
/// highest within a ring says nothing of where the foot and the rim of a wall are: it would be a
/// ramp between two rings, of another length along each ray. So the ring before a wall's gets the
/// foot and its own ring the rim, unless a point is lost by it that looks higher than what follows.
/// Within a ring a wall is as steep as where it is steepest, so that both ends are found between
/// the points that were looked at.
class WallVertices {
  public:
    /// A wall rises by that slope or more.
    explicit WallVertices(double slope) : slope_(slope) {}

    void begin_ray();
    /// The points of the next ring, of which one looks highest.
    void take(std::span<const RaySample> ring, std::size_t highest);
    /// A point for each ring.
    [[nodiscard]] std::span<const RaySample> chosen() const { return chosen_; }

  private:
    double slope_;
    std::vector<RaySample> chosen_;
    // Of the ring before:
    RaySample last_;       // its last point
    bool rising_ = false;  // that stands on a wall
    bool has_rim_ = false;
    RaySample rim_;
};

}  // namespace fumon
