#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "film/script/film.h"
#include "keys/assign.h"
#include "keys/override.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace fumon {

/// The sections of a scene that a film, or a shot of it, may have too: "camera", "look", "sun",
/// "air", "streamers", "person", "track", "layer".
const std::vector<std::string>& film_look_sections();

/// The key of the look that a path of a film means, without the shot it is of: "look.palette" of
/// "shot.1.look.palette"; empty where it means none.
std::string look_path(const std::string& path);

/// The keys of the look that are set at a path, by the film or by the shot that the path is of.
std::vector<Override>& looks_at(Film& film, const std::string& path);

/// Reads what stands under a path that look_path() knows: a value, a section or a list of sections.
/// Adds faults, located: keys that no look has, values out of range, and those that a film cannot
/// change.
void read_looks(Film& film, const std::string& path, const toml::node& value,
                const std::string& place, const Locate& locate, Faults& faults);

/// Sets one such key from the command line. Throws InputError, located.
void set_look(Film& film, const Override& setting);

/// A film's text with its looks put where they belong: the film's at the end, a shot's behind the
/// shot's own keys.
std::string with_looks(const std::string& toml, const Film& film);

/// The fields by whose names a film or its shots colour the ground (look.field).
std::vector<std::string> coloured_fields(const Film& film);

/// Whether two lists of settings give a scene the same look.
bool same_looks(const std::vector<Override>& first, const std::vector<Override>& second);

/// A scene with the look of a film, changed by `looks`. Persons, tracks and layers that are named
/// replace all of the scene's; layers are not laid over the bed yet. Throws InputError, located,
/// where the settings do not fit each other or the scene.
Scene with_looks(Scene scene, const Film& film, const std::vector<Override>& looks);

}  // namespace fumon
