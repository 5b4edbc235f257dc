#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "keys/keys.h"

namespace fumon {

/// The names of all looks, sorted: those of the files assets/looks/NAME.toml.
std::vector<std::string> look_preset_names();

/// Gives keys the values that a look has for them, in place of their defaults. A look is TOML, as a
/// scene, with keys of the role "look" alone. Throws InputError "PLACE: unknown look …" for a name
/// without a file, and one located in that file where it is wrong.
void apply_look_preset(const KeyTable& table, const std::string& name, std::string_view place);

}  // namespace fumon
