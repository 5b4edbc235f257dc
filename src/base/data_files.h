#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace fumon {

/// The path of a file that fumon ships ("shaders/terrain.frag.glsl",
/// "assets/palettes/viridis.txt"). Looked for in $FUMON_DATA_DIR, then beside the installed program
/// (../share/fumon), then in the source tree it was built from. Throws Error naming every place
/// looked at.
std::filesystem::path data_file(std::string_view relative);

/// The same path, or none where there is no such file.
std::optional<std::filesystem::path> find_data_file(std::string_view relative);

}  // namespace fumon
