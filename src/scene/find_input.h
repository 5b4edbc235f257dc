#pragma once

#include <filesystem>
#include <string_view>

#include "scene/initial_bed.h"

namespace fumon {

/// Finds an input of a picture, movie or run (`what`, at `place`): first the recorded path from the
/// working folder, then below the folder of `place` or one of its parents. Throws InputError if the
/// file is missing or its content has changed.
std::filesystem::path find_input(const InputFile& input, const std::filesystem::path& place,
                                 std::string_view what);

}  // namespace fumon
