#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "view/picture/look_changes.h"
#include "view/subject/subject.h"

namespace fumon {

/// The film file of {shots: [{seconds, keys: [{moment, eye, target}]}], settings}: a shot of one
/// key stands still, of more goes through their places while the run passes from the moment of the
/// first to that of the last. Settings of the sections that a film may have go with it. Throws
/// InputError where it is no film.
std::string film_file_of(const nlohmann::ordered_json& asked, ViewSubject& subject,
                         const LookChanges& changes);

}  // namespace fumon
