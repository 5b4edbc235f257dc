#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "render/view/camera.h"
#include "scene/scene.h"

namespace fumon {

/// Where a camera stands and what it looks at, as a page turns and moves it: lengths of the scene
/// (metres or sites), east and north of the bed's south-western corner and upward from the
/// picture's zero, heights exaggerated as they are drawn.
struct CameraPlace {
    std::array<double, 3> eye{};
    std::array<double, 3> target{};
};

/// What a page must know to move a camera.
struct CameraFacts {
    CameraPlace place;
    double azimuth = 0.0;    ///< degrees, where it stands
    double elevation = 0.0;  ///< degrees
    double distance = 1.0;   ///< from the block's centre, in block lengths
    double side = 1.0;       ///< a block length
    double tangent = 0.25;   ///< of half the picture's height
};

/// The camera of the picture of a snapshot, as the renderer places it for a still; over endless
/// ground that does not repeat it may be lifted further.
Camera camera_of_still(const Scene& scene, const Snapshot& first, const Snapshot& snapshot);

CameraFacts camera_facts(const Scene& scene, const Snapshot& first, const Snapshot& snapshot);

/// The settings camera.at, camera.look_at and camera.framing by which a still of a snapshot is
/// taken from a place.
std::vector<std::string> settings_of(const CameraPlace& place, const Scene& scene,
                                     const Snapshot& first, const Snapshot& snapshot);

}  // namespace fumon
