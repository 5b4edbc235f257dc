#pragma once

#include <span>
#include <string>

#include "base/snapshot.h"

namespace fumon {

/// A snapshot as a VTK XML file of a structured grid (.vts) for ParaView and VTK: nx × ny points at
/// the centres of the cells, on the bed's height (metres or model heights, times `exaggeration`),
/// where the terrain lies on a map in metres in its coordinates, else from the south-west corner.
/// Point data: bed_height, every field, the vector "velocity" of water, and vtkGhostType, which
/// hides points without data (their values are NaN). Appended raw, little-endian, 64-bit headers.
std::string vts_file(const Snapshot& snapshot, double exaggeration);

/// One file of a series and its time.
struct VtkMoment {
    double time = 0.0;
    std::string file;
};

/// A ParaView collection (.pvd) of such files.
std::string pvd_file(std::span<const VtkMoment> moments);

}  // namespace fumon
