#pragma once

#include <string>

#include "base/snapshot.h"

namespace fumon {

/// A section of air as a VTK XML file of a structured grid (.vts): its nodes in the plane y = 0,
/// z up, in metres (z times `exaggeration`). Point data: every field, the vector "velocity" of
/// velocity_x and velocity_z, and vtkGhostType, which hides the nodes below the bed.
std::string vts_section_file(const SnapshotSection& section, double time, double exaggeration);

/// The paths of its grains as a VTK XML file of lines (.vtp), in the same plane, with the cell data
/// launch_angle (degrees to the local bed).
std::string vtp_paths_file(const SnapshotSection& section, double time, double exaggeration);

}  // namespace fumon
