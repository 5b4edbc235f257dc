#pragma once

#include "base/grid.h"

namespace fumon {

/// A bed's edge on a doubly periodic lattice, and where a coast may be around it.
struct CoastEdge {
    Mask sea;             ///< of the edge's cells, those in the sea
    Mask land;            ///< and those on land
    double margin;        ///< cells beyond the bed within which land ends
    Field<int> from_end;  ///< of each cell: from the lattice's end, cells
};

/// How far inland each cell around a bed lies, in cells; below 0 at sea. From where the edge enters
/// the sea, shores run outwards so that the sea widens, also beyond a narrow inlet, and land ends
/// before the margin does. Both wander by headlands and bays of the margin's size and below, the
/// more the farther from the edge, and the same for lattices of the same size.
Grid inland_distances(const CoastEdge& edge);

/// Rises with `at` from 0, first by `slope` and then ever less, up to `most`.
double eased_rise(double at, double slope, double most);

/// Of the cells along a bed's edge, those in the sea: no higher than its level, and not alone.
/// `depth`: how many cells each lies within; 0 outside.
Mask edge_in_sea(const Grid& heights, const Field<float>& depth, double level);

}  // namespace fumon
