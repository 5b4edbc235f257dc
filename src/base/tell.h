#pragma once

#include <cstdio>
#include <string>

namespace fumon {

/// Writes text to standard error as it is. Where that cannot be written any more (a closed pipe, a
/// full disk) the text is dropped: work goes on without being watched.
inline void tell(const std::string& text) {
    if (std::fputs(text.c_str(), stderr) < 0) std::clearerr(stderr);
}

}  // namespace fumon
