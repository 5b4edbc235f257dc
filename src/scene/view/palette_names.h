#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// The names of all palettes, sorted.
std::vector<std::string> palette_names();

/// Throws InputError, without a place, for a name that no palette has.
void check_palette_name(std::string_view name);

}  // namespace fumon
