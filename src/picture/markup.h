#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// A text as it may stand between the tags, or in the quoted attributes, of HTML and XML: the five
/// special characters as entities, control characters and bytes that are no UTF-8 as "?".
std::string markup_text(std::string_view text);

}  // namespace fumon
