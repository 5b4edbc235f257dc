#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// The known name that a misspelt one most likely meant, by the smallest number of inserted,
/// deleted, replaced or swapped letters; empty when none is near (more than a third of its letters
/// off, or of those of a part between dots).
std::string nearest_name(std::string_view wrong, const std::vector<std::string>& known);

/// `did you mean "x"?` when a known name is near, else `known: a, b, c`.
std::string suggestion(std::string_view wrong, const std::vector<std::string>& known);

}  // namespace fumon
