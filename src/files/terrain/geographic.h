#pragma once

#include <string>

#include "base/grid.h"

namespace fumon {

/// Where a grid lies and how high its terrain is, in the unit of its file.
struct GridExtent {
    double west = 0.0;    ///< x of the western edge
    double south = 0.0;   ///< y of the southern edge
    double width = 0.0;   ///< columns × dx
    double height = 0.0;  ///< rows × dy
    double dx = 0.0;
    double dy = 0.0;
    double relief = 0.0;  ///< highest less lowest height, metres
};

/// Whether a grid whose file names no unit is in degrees. It is where all of this holds:
///  1. it fits the globe: west ≥ −180, east ≤ 360, south ≥ −90, north ≤ 90, no wider than 360 (each
///     with one cell to spare, for grids registered at cell centres);
///  2. its south-west corner is not exactly (0, 0), where local metric grids start, and its cells
///     are at most 5 wide and high;
///  3. its relief is more than twice its longer side: read as metres the terrain would be a needle.
/// A laboratory bed of 0.001 m cells therefore stays metric wherever its corner lies, since its
/// relief is a fraction of its length; a degree grid is taken for metres only if its ground rises
/// less than 2 m per 111 km, or if its corner is (0, 0), in the Gulf of Guinea.
bool is_geographic(const GridExtent& extent);

/// Lengths of one degree on the ellipsoid of WGS84.
struct DegreeLengths {
    double east = 0.0;   ///< metres per degree of longitude
    double north = 0.0;  ///< metres per degree of latitude
};

/// At a geodetic latitude φ in degrees: (π/180)·N·cos φ and (π/180)·M with the radii of curvature
/// N = a/w and M = a(1 − e²)/w³, w² = 1 − e² sin² φ. Source: Snyder (1987), Map Projections – A
/// Working Manual, USGS Professional Paper 1395, eqs. 4-18 to 4-21.
DegreeLengths degree_lengths(double latitude);

/// Cells in metres, and what the user should hear of it.
struct MetricCells {
    double dx = 0.0;  ///< metres
    double dy = 0.0;  ///< metres
    std::string note;
};

/// The cells of a grid in degrees, converted at its middle latitude.
MetricCells cells_from_degrees(double dx, double dy, double middle_latitude);

/// Highest less lowest height; negative where no cell has data.
double relief(const Grid& heights, const Mask& nodata);

}  // namespace fumon
