#include "keys/key_role.h"

#include <algorithm>
#include <array>

namespace fumon {

namespace {

constexpr std::array<KeyRoleText, 9> role_texts{
    {{KeyRole::run, "run", "which run is computed: its model, seed, length and terrain file"},
     {KeyRole::parameter, "parameter",
      "with what it is computed: the model's parameters, the grid, the first bed"},
     {KeyRole::sampling, "sampling", "at which steps it is measured and pictured"},
     {KeyRole::label, "label", "what the run is called in its files and pictures"},
     {KeyRole::record, "record", "which measurements and fields are written"},
     {KeyRole::file, "file", "which pictures, movies and beds are written"},
     {KeyRole::look, "look", "how pictures and movies look"},
     {KeyRole::sweep, "sweep", "which runs `fumon sweep` makes"},
     {KeyRole::figure, "figure", "what `fumon figure` draws"}}};

}  // namespace

std::span<const KeyRoleText> key_roles() {
    return role_texts;
}

std::string_view role_name(KeyRole role) {
    return std::find_if(role_texts.begin(), role_texts.end(),
                        [&](const KeyRoleText& text) { return text.role == role; })
        ->name;
}

}  // namespace fumon
