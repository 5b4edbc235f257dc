#pragma once

#include <string>

namespace fumon {

struct Terrain;

/// How heights come onto cells of another size.
enum class Resampling {
    average,   ///< mean over the new cell, by area: keeps volumes
    bilinear,  ///< linear between the centres of the four nearest cells
    nearest,   ///< of the cell in which the new one's centre lies
};

/// A terrain whose cells are `dx` × `dy` metres, on cells of `size` × `size` metres from its
/// south-western corner on; what remains at the northern and eastern edges is less than a cell and
/// falls away. A new cell holds no data where most of what it is made from has none: for an average
/// more than half of its area, else the cell in which its centre lies.
/// Throws InputError "WHAT: what is wrong; what would be right" where no new cell fits or more than
/// `largest_grid_cells` would.
Terrain resampled(const Terrain& terrain, double dx, double dy, double size, Resampling method,
                  const std::string& what);

}  // namespace fumon
