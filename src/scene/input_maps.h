#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// A key of a scene that names a file which its run reads.
struct InputKey {
    std::string path;   ///< "bed.file", "map.0.file"
    std::string* file;  ///< its value in the scene
};

/// The keys of a scene that name files which its run reads, in the order of InitialBed::inputs:
/// bed.file where it starts from one, then those of [[map]], then look.drape where there is one,
/// then those of [[layer]] that have one.
std::vector<InputKey> input_keys(Scene& scene);

/// Where such a file lies: as it stands on the command line, else as seen from the scene's folder.
std::filesystem::path input_path(const Scene& scene, const InputKey& key);

/// Puts a member of each input (its path, its hash) in the place of the file that the scene names.
void name_inputs(Scene& scene, const std::vector<InputFile>& inputs,
                 std::string InputFile::*member);

/// The same inputs by names that tell nothing of this machine, for what leaves it: a path from the
/// root of the file system becomes the file's name alone, any other stays.
std::vector<InputFile> without_local_paths(std::vector<InputFile> inputs);

/// Reads the maps of a scene, [[map]], and brings each to the cells of the bed that is there
/// already (on_cells): initial.maps, with their files at the end of initial.inputs and what the
/// user should hear in its note. Throws InputError, located at the key, where a file is missing,
/// cannot be read, is none of those that a picture's metadata lists, or does not fit the bed.
void add_maps(const Scene& scene, InitialBed& initial);

}  // namespace fumon
