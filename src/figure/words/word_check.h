#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// Throws InputError, after `place`, where fumon does not write a word or phrase of english_words,
/// or where another language's has not the same places for numbers: those are filled by fmt.
void check_word(const std::string& english, std::string_view own, const std::string& place);

}  // namespace fumon
