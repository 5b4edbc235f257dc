#pragma once

#include <string>
#include <vector>

#include "outputs/output_claims.h"
#include "picture/junit.h"

namespace fumon {

/// The JUnit report of a verification. An old one is gone from the start, so that no report is ever
/// of another run; a new one is there however the verification ends, unless the disk has no room.
class JunitFile {
  public:
    /// `file`: "" for none. Throws as check_ending() and OutputClaims::writes(), Error where the
    /// old one cannot be removed.
    JunitFile(std::string file, OutputClaims& claims);

    /// Throws Error.
    void write(const std::vector<JunitCase>& cases);

    /// Unless it was written: writes that the verification could not begin, or not end.
    /// Tells on standard error where that cannot be written.
    void write_fault(Outcome outcome, const std::string& fault) noexcept;

  private:
    std::string file_;
    std::string began_;  ///< ISO 8601, UTC
    bool written_ = false;
};

}  // namespace fumon
