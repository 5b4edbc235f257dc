#pragma once

#include <filesystem>
#include <vector>

#include "film/script/film.h"
#include "keys/override.h"
#include "scene/initial_bed.h"

namespace fumon {

/// Whether a setting of a look names a layer's file.
bool names_layer_file(const Override& setting);

/// Where the file lies that a layer's setting names: as `found` says, else as seen from the film's
/// folder, or for the command line from the working folder. Throws InputError where a movie or
/// picture holds the film and `found` lacks the file: others may have written that film.
std::filesystem::path layer_file(const Override& setting, const LayerFiles& found);

/// The files that the layers of a film, its shots and its excerpts name, as they are written there,
/// with their hashes (grid_hash), in order. Throws as layer_file(), and InputError for one that
/// cannot be read.
std::vector<InputFile> layer_inputs(const Film& film);

}  // namespace fumon
