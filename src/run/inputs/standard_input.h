#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "files/scratch_folder.h"
#include "scene/read.h"

namespace fumon {

/// The name by which a command is given its standard input: "-".
bool is_standard_input(const std::string& given);

/// What a command was given there: the text of a scene, or a file of terrain.
class StandardInput {
  public:
    /// Reads it to its end. Throws InputError where it is a terminal, empty, or longer than
    /// `largest_input_file`.
    StandardInput();

    [[nodiscard]] bool is_scene() const { return terrain_.empty(); }
    /// As a scene of a file in the working folder; messages call it "standard input".
    [[nodiscard]] SceneText scene() const;
    /// A file with the same bytes, as long as this lives. Throws InputError for a scene.
    [[nodiscard]] const std::filesystem::path& terrain() const;

  private:
    std::string bytes_;
    std::unique_ptr<ScratchFolder> folder_;  ///< of terrain
    std::filesystem::path terrain_;
};

/// The ending by which a file of terrain is known, from its first bytes: ".png", ".nc", ".tif" or
/// ".asc"; empty for anything else.
std::string_view terrain_ending_of(std::string_view bytes);

}  // namespace fumon
