#pragma once

#include <filesystem>
#include <string>

namespace fumon {

/// The file of a scene that a command or a coupling program was given: the path as it stands where
/// there is such a file; else a scene that fumon ships by its bare name ("terada-barchans" or
/// "sudo-2002-06.toml"), found from any folder. What is neither comes back as it stands, for
/// whoever reads it to refuse; a bare word is refused here by an InputError that names the nearest
/// shipped scene.
std::string scene_argument(const std::string& given);

/// Whether a command was given a scene rather than terrain. A file without an ending is no terrain,
/// and may be the name of a scene that fumon ships.
bool is_scene_argument(const std::filesystem::path& given);

/// As scene_argument() of a terrain file, with its ending: "west_bijou_gully.asc" is found from any
/// folder.
std::string terrain_argument(const std::string& given);

}  // namespace fumon
