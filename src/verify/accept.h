#pragma once

#include <string>
#include <vector>

#include "verify/suites.h"

namespace fumon {

/// Takes the new pictures that the last results have of the cases options.accepts over as the
/// expected ones, without drawing anything. Returns the exit status. Throws InputError, with
/// nothing written, where one of them is not there, Error where they cannot be written.
int accept_results(const VerificationOptions& options, std::vector<Suite>& suites);

/// The command line that does so for one case: "fumon verify dunes.toml --accept map".
std::string accept_command(const std::string& baseline, const std::string& name,
                           const std::string& folder);

}  // namespace fumon
