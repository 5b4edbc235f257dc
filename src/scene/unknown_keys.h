#pragma once

#include <string>

#include "keys/keys.h"

namespace fumon {

/// Whether keys of the table stand under the path.
bool is_section(const KeyTable& table, const std::string& path);

/// Throws InputError, or KeyError of the key that was meant, for a path that is no key of the
/// table: what is wrong with it, and what would be right. `model` is the scene's, empty where it is
/// unknown.
[[noreturn]] void refuse_unknown_key(const std::string& path, const std::string& place,
                                     const KeyTable& table, const std::string& model);

}  // namespace fumon
