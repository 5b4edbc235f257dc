#pragma once

/// Water under a plane surface over a plane bed within a cell or along one of its faces: its depth
/// is max(0, d), with d linear. Lengths are in cells.
namespace fumon::clipped_plane {

/// The mean over the cell of max(0, depth + rise_x·x + rise_y·y), −½ ≤ x, y ≤ ½.
double mean_depth(double depth, double rise_x, double rise_y);

/// The depth at the middle, negative where that is dry, of which the mean is `mean` > 0.
double depth_of_mean(double mean, double rise_x, double rise_y);

struct MassCentre {
    double x = 0.0;
    double y = 0.0;
};

/// The water's centre of mass, as seen from the cell's middle; there where the cell is dry.
MassCentre centre_of_mass(double depth, double rise_x, double rise_y);

struct FaceMeans {
    double depth = 0.0;   ///< of max(0, d)
    double square = 0.0;  ///< of its square
    double centre = 0.0;  ///< of mass, from the face's middle toward where the surface rises
};

/// The means along a face, with `depth` at its middle and `rise` along it.
FaceMeans means_along(double depth, double rise);

}  // namespace fumon::clipped_plane
