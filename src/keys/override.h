#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fumon {

/// A value for a scene key that comes from outside the scene's file.
struct Override {
    std::string path;        ///< of the key: "model.creep_rate", or of a list's item: "frames.at.0"
    std::string value;       ///< TOML, else a bare string
    std::string place;       ///< what messages call it: "--set 2"
    std::size_t column = 0;  ///< of the value in there, counted from 1; 0: the place alone
};

/// The overrides of "key.path=VALUE" texts, placed as "--set N", or where they stand in a scene.
/// Throws InputError for the texts without a key.
std::vector<Override> read_settings(const std::vector<std::string>& settings,
                                    const std::string& scene_place = {});

/// The value as plain text: a quoted string without its quotes, all else as written.
std::string plain_text(const Override& override);

}  // namespace fumon
