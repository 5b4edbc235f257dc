#pragma once

#include "render/view/ground_tiles.h"

/// The loop over the points along a ray that a mesh of the ground takes, see vectors/target.h: the
/// same bits on every target.
namespace fumon::ground_vectors {

/// Heights of a periodic bed, or means of them, x fastest; or of the maps of a bed in its plain.
struct Heights {
    const float* values;
    int nx;
    int ny;
    GroundTiles tiles{};
};

/// From where it is seen.
struct Eye {
    double height;
    double curvature;  ///< by which the planet sinks at a distance of 1
    double mean;       ///< of the bed's heights
};

/// Points over it: numbers of each.
struct RaySamples {
    const double* radii;  ///< from the eye
    const double* east;   ///< periods of the bed, or its tiles: 0 and 1 are its two ends
    const double* north;
    /// How high the ground stands, of the bed's height from its mean; see TileWarp. nullptr: as
    /// on the bed.
    const double* raised;
};

/// Points are looked at so many at once at most: as many numbers are read, and heights and tangents
/// written, as the next multiple of it has.
constexpr int samples_per_batch = 16;

/// How far the ground lies over the eye at `count` points, and the tangents of the elevations at
/// which that is seen: as HeightPyramid::at() for each.
void evaluate(const Heights& bed, const Eye& eye, const RaySamples& positions, int count,
              double* over, double* tangents);

/// Points along a ray, from the middle of what TileWarp leaves as it is; periods.
struct WarpedRay {
    double east;  ///< under the eye
    double north;
    double east_per_length;
    double north_per_length;
    double strength;
};

/// How far aside of them ground is taken from, periods, and how high it stands, at `count` radii, a
/// multiple of samples_per_batch.
void warp_along_ray(const WarpedRay& ray, const double* radii, int count, double* east,
                    double* north, double* height);

}  // namespace fumon::ground_vectors
