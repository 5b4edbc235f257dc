#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "outputs/output_claims.h"
#include "picture/baseline.h"
#include "verify/verification.h"

namespace fumon {

/// A baseline, and what its part of the output folder is called.
struct Suite {
    Baseline baseline;
    std::string name;
    std::string fault{};  ///< why the baseline cannot be read; it has no cases then
};

/// A case, by the places of its suite and of itself in there.
struct ChosenCase {
    std::size_t suite;
    std::size_t number;
};

/// Where a baseline's records are kept.
std::filesystem::path recorded_in(const Baseline& baseline);

/// Reads all baselines. One that cannot be read is a suite with a fault. What is recorded without a
/// case is a case with a fault, unless it is to be recorded anew. Each suite has a name of its own.
std::vector<Suite> read_suites(const VerificationOptions& options);

/// Notes every file that the cases read. What cannot be read is told when the case is drawn.
void note_inputs(const VerificationOptions& options, const std::vector<Suite>& suites,
                 OutputClaims& claims);

/// Claims the locks of chosen cases and the pictures that are kept of them: they are fumon's where
/// something is recorded. Throws as OutputClaims::writes().
void claim_records(const VerificationOptions& options, const std::vector<Suite>& suites,
                   const std::vector<ChosenCase>& chosen);

}  // namespace fumon
