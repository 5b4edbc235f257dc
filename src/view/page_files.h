#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "view/server/http_server.h"

namespace fumon {

/// A file of a page by its name alone: "" is the page itself, of this name. None for any other
/// name, whatever lies beside them.
std::optional<HttpAnswer> page_file(std::string_view name, std::string_view page = "view.html");

}  // namespace fumon
