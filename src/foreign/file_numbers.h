#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// A file of a series and the number in its name that orders it: a count, or seconds from
/// 1970-01-01 of a date.
struct NumberedFile {
    std::filesystem::path file;
    double number = 0.0;
};

/// Files in the order of the numbers in their names: of the last number that differs among them, or
/// of the dates that a pattern of %Y, %m, %d, %H, %M, %S, %j and %y describes. Throws InputError,
/// naming the file, for a name without a number or date, and for two files of one number.
std::vector<NumberedFile> in_order(const std::vector<std::filesystem::path>& files,
                                   const std::string& time_pattern);

/// Where a date of the pattern stands in a text, as seconds from 1970-01-01; the leftmost one.
std::optional<std::int64_t> find_date(std::string_view text, std::string_view pattern);

/// Whether a text is a pattern of names: it has * or ?.
bool is_pattern(std::string_view text);

/// The files whose names fit a pattern, * and ? of the last part of the path; sorted by name.
/// Throws InputError where there are none.
std::vector<std::filesystem::path> files_of_pattern(const std::string& pattern);

}  // namespace fumon
