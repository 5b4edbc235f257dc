#pragma once

#include <string>

namespace fumon {

/// An ICC profile (version 2.1) of sRGB (IEC 61966-2-1): the colours of its primaries as seen under
/// D50, and its curve in 1024 steps. The same bytes on every machine.
std::string srgb_profile();

/// The name by which the profile calls itself.
inline constexpr const char* srgb_name = "sRGB IEC61966-2.1";

}  // namespace fumon
