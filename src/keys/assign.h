#pragma once

#include <toml++/toml.h>

#include <functional>
#include <string>

#include "keys/keys.h"

namespace fumon {

/// "file:line:column" of a place in the text being read.
using Locate = std::function<std::string(const toml::source_region&)>;

/// Sets a key from a TOML value after checking its type and range. Whole numbers serve as real
/// ones, and reals as whole ones when exact. Throws InputError located at the value (or at the list
/// item).
void assign(const Key& key, const toml::node& value, const Locate& locate);

/// Sets item `index` of a list key. Throws InputError if the key is not a list or has no such item.
void assign_item(const Key& key, std::size_t index, const toml::node& value, const Locate& locate);

/// "a whole number", "one of \"a\", \"b\"", … : what a key takes, with unit and range.
std::string accepted_values(const Key& key);

}  // namespace fumon
