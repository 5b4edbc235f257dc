#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace fumon {

/// All bytes of a regular file. Throws InputError "FILE: cannot be read: REASON; …" for a missing
/// file, a folder, a pipe or device, a file one may not read, and one larger than
/// `largest_input_file`; Error where the system fails to read it: a broken disk, too many open
/// files.
std::string read_input_file(const std::filesystem::path& file);

/// The first bytes of such a file, however large it is: at most `count`. Throws as read_input_file.
std::string start_of_input_file(const std::filesystem::path& file, std::size_t count);

/// Throws "FILE: cannot be read: REASON" for an errno value: Error where the machine fails, as a
/// disk does, and otherwise InputError with a remedy.
[[noreturn]] void refuse_to_read(const std::filesystem::path& file, int reason);

/// Hands on the first bytes of such a file, at most `count`, block by block. Throws as
/// read_input_file, and what `take` throws.
void stream_input_file(const std::filesystem::path& file, std::int64_t count,
                       const std::function<void(std::string_view)>& take);

/// Bytes. A terrain of the largest size allowed (2^27 cells) at 32 characters a cell.
inline constexpr long long largest_input_file = 1LL << 32;

}  // namespace fumon
