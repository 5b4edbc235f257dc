#pragma once

#include <string>

#include "base/image.h"
#include "picture/baseline.h"

namespace fumon {

/// What became of a case under test.
enum class Outcome {
    as_recorded,
    differs,
    missing,     ///< nothing is recorded to compare with
    failed,      ///< it could not be drawn
    wrong_input  ///< its scene is wrong
};

/// "as-recorded", "differs" …: as JSON and JUnit have it.
const char* name_of(Outcome outcome);

struct Verdict {
    Outcome outcome = Outcome::missing;
    std::string finding;  ///< one line: the tier and why, and what was found
};

/// By which of a case's records a picture is judged, where the case has several.
struct RecordUse {
    std::string which{};         ///< for the verdict: "environment gpu"; empty where there is one
    bool is_known_here = false;  ///< it is that of the very environment, in which pixels are equal
};

/// Judges a picture by what is recorded of it. The state's hash must be the recorded one. Where the
/// pixels must be equal (see why_pixels_may_differ), their hash must be, too: the strict tier.
/// Else, in the portable tier, the thumbnail and, where the expected picture was kept, every tile's
/// SSIM must be within the case's limits. `recorded` and `expected` may be null. A record of a
/// known environment is always of the strict tier. What is ignored must be what was ignored when it
/// was recorded; `present` is of the picture without it.
Verdict judge(const BaselineCase& one, const BaselineRecord* recorded,
              const BaselineRecord& present, const Image& got, const Image* expected,
              const RecordUse& use = {}, const IgnoredPixels& ignored = {});

/// What changed from one record to another, for a person, by commas; empty where nothing did.
std::string changes(const BaselineRecord& before, const BaselineRecord& after);

}  // namespace fumon
