#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "keys/override.h"
#include "scene/scene.h"
#include "scene/text/scene_text.h"

namespace fumon {

/// Reads a scene file; `settings` are "key.path=VALUE" overrides of the command line, applied in
/// order, with the same checks and located as `--set N:column`. VALUE is read as TOML, else as a
/// bare string; list items are addressed by number (frames.at.0=50). Throws InputError with a line
/// "file:line:column: what is wrong; what would be right" for each fault, see Faults: an unknown
/// key, a wrong type, a number out of range, an unknown model, keys that contradict; or for the
/// place where the text is no TOML.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

/// The same for a scene's text; `source` names it in messages and `directory` is where its
/// relative files are looked for.
Scene parse_scene(std::string_view text, const std::string& source,
                  const std::filesystem::path& directory,
                  const std::vector<std::string>& settings = {});

/// The scene of a text with overrides applied in order; throws as read_scene.
Scene parse_scene(const SceneText& text, const std::vector<Override>& overrides);

}  // namespace fumon
