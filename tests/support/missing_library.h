#pragma once

#include <string>

namespace fumon::test {

/// Whether a context could not be made because the library is not installed; anything else is a
/// fault.
inline bool library_is_missing(const std::string& error) {
    return error.find("cannot open shared object file") != std::string::npos;
}

}  // namespace fumon::test
