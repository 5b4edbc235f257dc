#pragma once

#include <string>

namespace fumon::test {

/// Whether a context could not be made because the library is not installed, or because fumon was
/// built without it; anything else is a fault.
inline bool library_is_missing(const std::string& error) {
    return error.find("cannot open shared object file") != std::string::npos ||
           error.find("this fumon was built without it") != std::string::npos;
}

}  // namespace fumon::test
