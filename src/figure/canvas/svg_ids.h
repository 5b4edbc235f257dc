#pragma once

#include <string>

namespace fumon {

/// An SVG file whose numbered ids ("surface12", and "#surface12" where it is used) count from 1 in
/// the order in which they first appear: Cairo numbers them through all that a process has drawn.
std::string with_counted_ids(const std::string& svg);

}  // namespace fumon
