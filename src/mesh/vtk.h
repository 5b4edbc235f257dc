#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/snapshot.h"

namespace fumon {

inline constexpr std::uint8_t vtk_hidden_point = 2;  // vtkDataSetAttributes::HIDDENPOINT

/// The element that tells a file's time.
std::string vtk_time_element(double time);

/// A snapshot as a VTK XML file of a structured grid (.vts) for ParaView and VTK: nx × ny points at
/// the centres of the cells, on the bed's height (metres or model heights, times `exaggeration`),
/// where the terrain lies on a map in metres in its coordinates, else from the south-west corner.
/// Point data: bed_height, every field, the vector "velocity" of water, and vtkGhostType, which
/// hides points without data (their values are NaN); over a bed that has a section, its curves, at
/// the section's columns. The arrays are compressed (vtk_arrays.h).
std::string vts_file(const Snapshot& snapshot, double exaggeration);

/// The files of one moment of a series (its bed; of air the section and the paths of grains too).
struct VtkMoment {
    double time = 0.0;
    std::vector<std::string> files;
};

/// A ParaView collection (.pvd) of such files, one part each; a comment says how many moments.
std::string pvd_file(std::span<const VtkMoment> moments);

}  // namespace fumon
