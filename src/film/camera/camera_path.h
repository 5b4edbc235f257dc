#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace fumon {

/// Where a film's camera stands, what it looks at and in which light, in the block's lengths (see
/// Block).
struct CameraPose {
    glm::dvec3 eye{0.0};
    glm::dvec3 look_at{0.0};
    double focal_length = 50.0;  ///< mm, of a lens before 24 mm along the picture's shorter side
    double sun_azimuth = 0.0;    ///< degrees
    double sun_elevation = 30.0;
    double exposure = 0.0;  ///< stops

    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// The way of a camera through some poses: a centripetal Catmull-Rom spline (Catmull & Rom 1974;
/// Yuksel, Schaefer & Keyser 2011, α = 1/2, evaluated after Barry & Goldman 1988), on which the eye
/// moves at one speed. What else a pose holds goes through the same knots. Where the eye stands
/// between two poses, the point that it looks at sets the pace.
class CameraPath {
  public:
    /// The least height of an eye at a place east and north, block lengths.
    using Floor = std::function<double(double x, double y)>;

    /// What the share of the way counts: distance, or the poses, which are then as long in time
    /// from one another.
    enum class Timing { distance, poses };

    /// One pose at least. Where the floor would be above the eye, the way is lifted, smoothly and
    /// along a stretch before and after it.
    explicit CameraPath(const std::vector<CameraPose>& poses, const Floor& floor = {},
                        Timing timing = Timing::distance);

    /// The pose at a share of the way, 0 … 1.
    [[nodiscard]] CameraPose at(double share) const;
    /// Of the eye's way, block lengths.
    [[nodiscard]] double length() const { return length_; }
    /// By how much the eye's way lay below the floor, block lengths.
    [[nodiscard]] double lifted() const { return lifted_; }

  private:
    std::vector<CameraPose> samples_;  ///< dense
    std::vector<double> distances_;    ///< of each from the first, along the way
    double length_ = 0.0;
    double lifted_ = 0.0;
    Timing timing_;
};

/// Starts and stops gently: 0 … 1, with no speed at both ends (3u² − 2u³).
double eased(double share);

}  // namespace fumon
