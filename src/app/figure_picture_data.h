#pragma once

#include <string>

#include "figure/profile_panel.h"
#include "figure/time_space_panel.h"

namespace fumon {

/// Profiles as CSV: x, then a column for each bed and each water surface.
std::string profile_csv(const ProfilePicture& picture);

/// A time–space diagram as CSV: a row a time and place.
std::string time_space_csv(const TimeSpacePicture& picture);

}  // namespace fumon
