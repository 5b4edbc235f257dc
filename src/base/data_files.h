#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace fumon {

/// Names a folder with fumon's files, for a library that lies elsewhere than the program: looked at
/// after $FUMON_DATA_DIR. Call it before other threads start.
void add_data_folder(std::filesystem::path folder);

/// The same of the files that were installed with a library: in share/fumon below a folder above
/// it. Without them nothing is named.
void add_data_of_library(const std::filesystem::path& library);

/// The path of a file that fumon ships ("shaders/block/terrain.frag.glsl",
/// "assets/palettes/viridis.txt"). Looked for in $FUMON_DATA_DIR, then in folders that were added,
/// beside the installed program
/// (../share/fumon), then in the source tree it was built from. Throws Error naming every place
/// looked at.
std::filesystem::path data_file(std::string_view relative);

/// The same path, or none where there is no such file.
std::optional<std::filesystem::path> find_data_file(std::string_view relative);

/// The path of a file of the documentation that is installed beside the program
/// (../share/doc/fumon), or else of the source tree.
std::optional<std::filesystem::path> find_document(std::string_view relative);

}  // namespace fumon
