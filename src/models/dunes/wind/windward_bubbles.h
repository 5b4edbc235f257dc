#pragma once

#include "base/grid.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// The still air before steep slopes that face the wind, such as slip faces that another wind has
/// left. The wind does not follow such a slope: it separates at its foot and rises to the crest
/// over a bubble, so that steeper ground speeds it up no more. Codes for winds over hills hold the
/// speed-up from an upwind slope of 0.3 on, over a length of height / 0.3 (EN 1991-1-4:2005, A.3);
/// 0.3 is 16.7 degrees.
///
/// From every point a surface falls upwind at an angle; bubbles lie between it and lower ground.
/// They are separation bubbles as those behind crests (see WindShadow), seen by a wind that blows
/// the other way.
class WindwardBubbles {
  public:
    /// `tangent`: of the angle.
    WindwardBubbles(const DuneGround& ground, double tangent, WorkerPool& pool);

    const WindwardBubbles& find(const FixedPointGrid& surface, const BlowingWind& wind);

    /// Lifts heights, in metres, to the bubbles' surface.
    void fill(Grid& relief) const;

  private:
    double tangent_;
    WorkerPool& pool_;
    WindShadow against_;
};

/// Throws KeyError for bubbles where no shear stress knows of them.
void check_windward_bubbles(const DunesParameters& parameters);

}  // namespace fumon
