#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "film/script/film.h"
#include "keys/override.h"
#include "scene/initial_bed.h"

namespace fumon {

/// Whether a setting of a look names a layer's file.
bool names_layer_file(const Override& setting);

/// A layer's file as a film records it.
struct LayerRecord {
    std::string
        key;  ///< of the layer's setting, see for_each_layer(); empty in films of older versions
    InputFile input;   ///< as the film or the command line writes it
    std::string from;  ///< the same file as seen from where the film was made, where that is no
                       ///< path of one machine; else empty
};

/// A setting of a layer's file, and its key in all of a film: "layer.0.file",
/// "shot.1.layer.0.file" or, of its second excerpt, "excerpt.1.layer.0.file".
using UseLayer = std::function<void(const std::string& key, Override& setting)>;
void for_each_layer(Film& film, const UseLayer& use);

/// Whether the command line, not the film, names a file.
bool is_given_now(const Override& setting);

/// Where the file lies that a layer's setting names: as `found` says of its key or of what it
/// names, else as seen from the film's folder, or for the command line from the working folder.
/// Throws InputError where a movie or picture holds the film and `found` lacks the file: others may
/// have written that film.
std::filesystem::path layer_file(const Override& setting, const LayerFiles& found,
                                 const std::string& key = {});

/// The files of all layers of a film, its shots and its excerpts, with their hashes (grid_hash).
/// Throws as layer_file(), and InputError for one that cannot be read.
std::vector<LayerRecord> layer_records(Film film);

/// The film with the files of all its layers named by their whole paths, so that two in different
/// folders are told apart.
Film with_whole_layer_paths(Film film);

}  // namespace fumon
