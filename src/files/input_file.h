#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace fumon {

/// All bytes of a regular file. Throws InputError "FILE: cannot be read: REASON; …" for a missing
/// file, a folder, a pipe or device, a file one may not read, and one larger than
/// `largest_input_file`; Error where the machine fails.
std::string read_input_file(const std::filesystem::path& file);

/// The first bytes of such a file, however large it is: at most `count`. Throws as read_input_file.
std::string start_of_input_file(const std::filesystem::path& file, std::size_t count);

/// Throws "FILE: cannot be read: REASON" for an errno value: Error where the machine fails, as a
/// disk does, and otherwise InputError with a remedy.
[[noreturn]] void refuse_to_read(const std::filesystem::path& file, int reason);

/// Bytes. A terrain of the largest size allowed (2^27 cells) at 32 characters a cell.
inline constexpr long long largest_input_file = 1LL << 32;

}  // namespace fumon
