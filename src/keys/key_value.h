#pragma once

#include <string>

#include "keys/keys.h"

namespace fumon {

/// One key's value as TOML ("0.1", "[50, 100]", "\"synchronous\""). Read again it is the same.
std::string value_text(const Key& key);

/// Gives a key the value of another one, of the same type.
void copy_value(const Key& from, const Key& to);

}  // namespace fumon
