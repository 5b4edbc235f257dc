#pragma once

#include <vector>

#include "verify/suites.h"

namespace fumon {

/// Tells the chosen cases on standard output, a line each: the baseline's file and the case's name;
/// as JSON with the scene, too. What is wrong in them goes to standard error. Returns the exit
/// status.
int list_cases(const VerificationOptions& options, const std::vector<Suite>& suites);

}  // namespace fumon
