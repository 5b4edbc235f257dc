#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// 128 random bits of the system as 32 hexadecimal digits. Throws Error where the system gives
/// none.
std::string random_token();

/// Whether two texts are the same, in a time that tells nothing of where they differ.
bool same_secret(std::string_view first, std::string_view second);

}  // namespace fumon
