#pragma once

#include <string>

#include "verify/verification.h"

namespace fumon {

/// Where results go unless -o says.
inline constexpr const char* usual_results = "verify-out";

/// Where results go.
struct ResultsFolder {
    std::string folder;         ///< "": a temporary one, made with the first result
    std::string why_temporary;  ///< the system's reason why `usual_results` is not taken
};

/// The folder that -o names, else `usual_results`, else, where that cannot be made or written (as
/// in a checkout that may only be read), a temporary one. Makes nothing. Throws InputError for what
/// can be no folder, Error where the one that -o names cannot be written.
ResultsFolder results_folder(const VerificationOptions& options);

/// Where the last results are looked for.
std::string last_results(const VerificationOptions& options);

}  // namespace fumon
