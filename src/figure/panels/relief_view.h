#pragma once

#include <span>

#include "base/image.h"
#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// Along which horizontal direction a bed's heights change most: the first eigenvector of the
/// gradients' covariance, across the crests of a bed that has some.
struct SlopeDirection {
    double azimuth = 0.0;    ///< degrees clockwise from north, 0 … 180; of an axis
    double coherence = 0.0;  ///< 0 where all directions are alike … 1 where all crests are parallel
};

/// Of a snapshot's cells with data.
SlopeDirection slope_direction(const Snapshot& snapshot);

/// Where the sun stands, degrees clockwise from north, so that a bed seen from `camera_azimuth`
/// reads: to the upper left of the picture, turned towards the line across the crests, the more so
/// the more parallel these are.
double relief_light_azimuth(const SlopeDirection& slopes, double camera_azimuth);

/// A view as a figure shows the relief of some snapshots of a run that begins with `first`:
/// look.mode = "figure", look.relief = "clear" and a block that is no thicker than these snapshots
/// need, before nothing. Where the scene leaves them to fumon, the sun stands as
/// relief_light_azimuth() says and the exaggeration is figure_exaggeration().
View relief_view(View view, const Snapshot& first, std::span<const Snapshot> snapshots);

/// A picture with an outline along the edge between what is opaque and what is not, `width` pixels
/// wide, laid on white. A picture without opacities stays as it is.
Image outlined(const Image& image, double width);

}  // namespace fumon
