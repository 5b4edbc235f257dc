#pragma once

#include <cstdio>
#include <string>

namespace fumon {

/// Writes text to standard error as it is. If that is no longer possible (a closed pipe, a full
/// disk), the text is dropped and work continues.
inline void print_to_stderr(const std::string& text) {
    if (std::fputs(text.c_str(), stderr) < 0) std::clearerr(stderr);
}

}  // namespace fumon
