#pragma once

#include <string>
#include <vector>

#include "run/terminal/work_options.h"
#include "verify/annotations.h"

namespace fumon {

/// What `fumon verify` is asked.
struct VerificationOptions {
    std::vector<std::string> baselines;
    std::string folder = "verify-out";  ///< made only when something does not pass
    std::string junit;                  ///< a file of JUnit XML; empty: none
    bool update = false;                ///< record instead of comparing
    bool force = false;                 ///< replace files of others, too
    bool trust = false;                 ///< what the baselines name, without limits
    bool as_json = false;               ///< what is found is printed as JSON alone
    ReportFormat format = ReportFormat::lines;
    WorkOptions work;

    [[nodiscard]] bool quietly() const { return work.verbosity == Verbosity::quiet; }
};

/// Draws every case of the baselines and compares it with its record (or records it), saying on
/// standard output what it finds. Returns the exit status: 0 where all is as recorded, 1 where
/// something is not, 2 where a case cannot be right, 128 + signal when interrupted. Throws
/// InputError before anything is drawn where a baseline is wrong, Error where a file cannot be
/// written.
int verify(const VerificationOptions& options);

}  // namespace fumon
