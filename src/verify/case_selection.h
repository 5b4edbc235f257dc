#pragma once

#include <string_view>
#include <vector>

#include "verify/suites.h"

namespace fumon {

/// Whether a pattern of -k means a case: a part of its name, or with *, ? and [ a pattern of the
/// whole as in a shell. A pattern with a slash is held against SUITE/NAME.
bool chooses(std::string_view pattern, const std::string& suite, const std::string& name);

/// The cases that the names, patterns and shard mean, in their order. Throws InputError for a name
/// or pattern that means none.
std::vector<ChosenCase> chosen_cases(const VerificationOptions& options,
                                     const std::vector<Suite>& suites);

}  // namespace fumon
