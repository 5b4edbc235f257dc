#pragma once

#include <string>

namespace fumon {

/// The keys of every scene ("scene"), of one model (its name), or all ("") as a text to read.
/// Throws InputError for a name that is neither, with the nearest known one.
std::string describe_text(const std::string& what);

/// The same as JSON: a list of what key_json() tells, with the model or null.
std::string describe_json(const std::string& what);

/// One line a model: name and what it is.
std::string models_text();

}  // namespace fumon
