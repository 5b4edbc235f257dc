#pragma once

#include <string>

#include "view/server/http_server.h"

namespace fumon {

/// The address of a server, and a second line with the `ssh` that brings it to the machine of who
/// is logged in from elsewhere.
std::string address_lines(const HttpServer& server);

}  // namespace fumon
