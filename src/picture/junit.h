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
    std::string expected_pixels{};  ///< SHA-256, hexadecimal; empty where nothing is recorded
    std::string got_pixels{};       ///< empty where nothing was drawn
};

/// JUnit XML as CI services read it, Jenkins by its schema junit-10.xsd: a testsuite for each run
/// of cases of one suite, with the hashes of their pixels as its properties; a case that differs or
/// is missing is a failure, one that could not be drawn an error. What was found is the message,
/// and of a case that passes its standard output. Cases of two baseline files have two class names:
/// their paths without ending, with dots between folders. `timestamp`: when the suites began, ISO
/// 8601 in UTC without a zone.
std::string junit_xml(const std::vector<JunitCase>& cases, const std::string& timestamp);

}  // namespace fumon
