#pragma once

#include <filesystem>
#include <string_view>

#include "scene/initial_bed.h"

namespace fumon {

/// Where an input of a picture, movie or run (`what`, at `place`) lies now: from the working folder
/// as recorded, else below the place's own folder or one of its parents. Throws InputError where it
/// is not there or is no longer what it was then.
std::filesystem::path find_input(const InputFile& input, const std::filesystem::path& place,
                                 std::string_view what);

}  // namespace fumon
