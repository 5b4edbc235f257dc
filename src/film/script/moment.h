#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// A moment of a run as films write it in words: "40 %", "3 yr".
struct WrittenMoment {
    double number = 0.0;
    std::string unit;  ///< "%", or of time, in UDUNITS' syntax
};

/// A number, 0 or more, and a unit behind it, with or without blanks between; nothing for another
/// text, a share above 100 % and a unit that is none of time. Throws Error where the database of
/// UDUNITS cannot be read.
std::optional<WrittenMoment> written_moment(std::string_view text);

/// Whether a text is a share of a run: "40 %".
bool is_written_share(std::string_view text);
/// Whether a text is a time of a run: "3 yr".
bool is_written_time(std::string_view text);

}  // namespace fumon
