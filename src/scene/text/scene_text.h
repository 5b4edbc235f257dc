#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fumon {

/// The text of a scene's file when it was read.
struct SceneText {
    std::string text;
    std::string source;               ///< names it in messages
    std::filesystem::path directory;  ///< where its relative files are looked for
    bool trusted = true;              ///< see Scene::trusted
    std::shared_ptr<const std::vector<std::string>> bed_hashes{};  ///< see Scene::bed_hashes
    std::string version{};  ///< of the fumon whose defaults hold where the text says nothing; empty
                            ///< for this one's
    bool resolved = false;  ///< it says all keys that the fumon had which kept it
};

/// Reads it from a file or a pipe. Throws InputError where it cannot be read, is a folder or has
/// more than 16 MiB, and Error where the machine fails.
SceneText read_scene_text(const std::filesystem::path& file);

}  // namespace fumon
