#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "view/picture/picture_thread.h"
#include "view/server/http_server.h"

namespace fumon {

/// The JSON object of a request's body. Throws InputError for anything else.
nlohmann::ordered_json body_json(const HttpRequest& request);

/// Its "settings", at most 500 of at most 2000 letters each. Throws InputError.
std::vector<std::string> settings_in(const nlohmann::ordered_json& json);

/// {client, settings, moment, width, height, draft, eye, target}, all but the first left out as
/// needed. Throws InputError where one is of the wrong kind.
ViewRequest picture_request_in(const nlohmann::ordered_json& json);

/// Its "eye" and "target", three finite numbers each. Throws InputError.
CameraPlace place_in(const nlohmann::ordered_json& json);

}  // namespace fumon
