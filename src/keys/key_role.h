#pragma once

#include <span>
#include <string_view>

namespace fumon {

/// What a key of a scene decides. What a run is known by, which keys the runs of a sweep or a
/// figure share, what a caption lists and what is made again all follow from it.
enum class KeyRole {
    run,        ///< which run is computed: its model, seed, length and terrain file
    parameter,  ///< with what it is computed: the model's parameters, the grid, the first bed
    sampling,   ///< at which steps it is measured and pictured
    label,      ///< what the run is called in its files and pictures
    record,     ///< which measurements and fields are written
    file,       ///< which pictures, movies and beds are written
    look,       ///< how pictures and movies look
    sweep,      ///< which runs `fumon sweep` makes
    figure,     ///< what `fumon figure` draws
};

/// A role as `fumon describe` tells it.
struct KeyRoleText {
    KeyRole role;
    std::string_view name;
    std::string_view help;  ///< one line
};

/// All roles, in the order above.
std::span<const KeyRoleText> key_roles();

/// "look".
std::string_view role_name(KeyRole role);

}  // namespace fumon
