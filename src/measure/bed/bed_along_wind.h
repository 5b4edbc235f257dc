#pragma once

#include "base/grid.h"
#include "base/snapshot.h"
#include "base/snapshot_lookup.h"

namespace fumon {

/// A bed turned so that the wind blows along its rows, toward larger x, with sites of dx on both
/// axes.
struct BedAlongWind {
    Grid bed;
    bool periodic = false;
};

/// The bed of a snapshot without holes along a wind that blows toward `direction`. A wind along an
/// axis of a grid of square cells turns it exactly, and it stays periodic. Else heights are found
/// by cubic convolution (Keys 1981) on a grid about the middle of the bed: of a periodic bed one of
/// as many sites, else the largest one that lies in the bed; that grid ends at its edges.
BedAlongWind bed_along_wind(const Snapshot& snapshot, const HorizontalDirection& direction);

/// The height of a bed at a place in cells, by cubic convolution. Beyond the edges of a bed that is
/// not periodic its outermost cells go on.
double height_between(const Grid& bed, bool periodic, double x, double y);

}  // namespace fumon
