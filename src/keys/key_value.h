#pragma once

#include <string>

#include "keys/keys.h"

namespace fumon {

/// One key's value as TOML ("0.1", "[50, 100]", "\"synchronous\""). Read again it is the same.
std::string value_text(const Key& key);

/// Gives a key the value of another one, of the same type.
void copy_value(const Key& from, const Key& to);

/// Sets a key to what asks for nothing: false, 0, an empty list of numbers. Texts and choices,
/// which say how and not whether, stay.
void switch_off(const Key& key);

}  // namespace fumon
