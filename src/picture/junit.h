#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "picture/verdict.h"

namespace fumon {

/// How the report's outermost element begins, by which it is known again.
inline constexpr std::string_view own_junit_mark = "<testsuites name=\"fumon verify\"";

/// One case of a JUnit report.
struct JunitCase {
    std::string suite;  ///< the baseline file
    std::string name;
    Verdict verdict;
    double seconds = 0.0;
};

/// JUnit XML as CI services read it: a testsuite for each run of cases of one suite; a case that
/// differs or is missing is a failure, one that could not be drawn an error. What was found is the
/// message, and of a case that passes its standard output.
std::string junit_xml(const std::vector<JunitCase>& cases);

}  // namespace fumon
