#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// A scene, figure or film that fumon ships.
struct ShippedScene {
    std::string name;  ///< "terada-barchans", "figures/sudo-2002-06", "films/barchans"
    std::filesystem::path file;
    std::string title;  ///< its own, or the first sentence of its comment
};

/// The folders below scenes/ that are listed; "": scenes/ itself.
inline const std::vector<std::string> shipped_folders{"", "figures", "films", "examinations"};

/// The scenes of some of these folders, in the order of the folders, then of their names.
std::vector<ShippedScene> shipped_scenes(const std::vector<std::string>& folders);

/// The scene that is meant by a word: its name, with or without its folder and ".toml", or a word
/// of its name ("barchans" of "dunes-barchans"). Several may be meant: in the order of
/// shipped_scenes. Throws InputError for an unknown one, with the nearest.
std::vector<ShippedScene> matching_scenes(const std::string& word);

/// The text of a shipped scene as it can stand anywhere: files that it names beside itself are
/// named by their whole path. Throws InputError where it cannot be read.
std::string relocatable_text(const ShippedScene& scene);

}  // namespace fumon
