#pragma once

#include <span>
#include <string>
#include <string_view>

#include "view/server/http_server.h"
#include "view/subject/subject.h"
#include "view/view_options.h"

namespace fumon {

/// A name for a file in the folder of --save: letters, digits, '.', '-', '_' and blanks, beginning
/// with a letter or digit, with one of some endings. Throws InputError for any other, paths too.
std::string saved_name(const std::string& name, std::span<const std::string_view> endings);

/// Writes a file into the folder of --save, by the rule of OutputClaims, and says where; without
/// that folder hands it to the browser under its name. Throws as OutputClaims::writes().
HttpAnswer saved(const ViewOptions& options, const ViewSubject& subject, const std::string& name,
                 const std::string& type, std::string bytes);

}  // namespace fumon
