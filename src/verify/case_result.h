#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/baseline_records.h"
#include "picture/verdict.h"
#include "verify/page_pictures.h"

namespace fumon {

/// What came of a case.
struct CaseResult {
    Verdict verdict;
    std::string word;             ///< "ok", "DIFFERS", "new" …: as standard output has it
    std::string detail;           ///< what it says behind it
    std::string expected_pixels;  ///< SHA-256, hexadecimal; empty where nothing is recorded
    std::string got_pixels;       ///< empty where nothing was drawn
    std::string name;             ///< of the record that this one would replace, see record_name()
    std::optional<BaselineRecord> got;
    std::vector<PagePicture> pictures;  ///< of a case that does not pass
    std::string kept;                   ///< the PNG that is to be kept beside the baseline
    double seconds = 0.0;
    int signal = 0;                  ///< that stopped it
    bool needs_new_process = false;  ///< memory ended: the process should do no other
};

/// How standard output calls an outcome.
const char* word_of(Outcome outcome);

/// A case of which nothing was drawn.
CaseResult undrawn(Outcome outcome, std::string finding);

/// A result as bytes, for another process of the same program, and back. The latter throws Error
/// where they are no such bytes.
std::vector<std::uint8_t> message_of(const CaseResult& result);
CaseResult result_of(const std::vector<std::uint8_t>& message);

}  // namespace fumon
