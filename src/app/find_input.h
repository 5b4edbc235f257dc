#pragma once

#include <filesystem>

#include "scene/initial_bed.h"

namespace fumon {

/// Where an input of a picture lies now: from the working folder as recorded, else below the
/// picture's own folder or one of its parents. Its content must be what the picture was made from;
/// throws InputError where it is not there or has changed.
std::filesystem::path find_input(const InputFile& input, const std::filesystem::path& picture);

}  // namespace fumon
