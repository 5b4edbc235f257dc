#pragma once

#include <string>

#include "figure/panels/profile_panel.h"
#include "figure/panels/section_panel.h"
#include "figure/panels/time_space_panel.h"

namespace fumon {

/// Profiles as CSV: x, then a column for each bed and each water surface.
std::string profile_csv(const ProfilePicture& picture);

/// A time–space diagram as CSV: a row a time and place.
std::string time_space_csv(const TimeSpacePicture& picture);

/// What a panel of a section shows, as CSV: the nodes with all fields behind a map, the columns
/// with all curves behind lines, the points of paths.
std::string section_csv(const SnapshotSection& section, SectionPanel panel);

}  // namespace fumon
