#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// Bytes as a deflated stream (RFC 1950).
std::string deflated(std::string_view bytes);

/// Bytes in the letters of Base64 (RFC 4648, section 4).
std::string base64_text(std::string_view bytes);

/// A text made short, for places that hold few letters: "deflate:" and the text, deflated
/// (RFC 1950), in the letters of Base64 (RFC 4648, section 4).
std::string packed_text(std::string_view text);

/// The text that packed_text() made short; none where the letters are not its own, are damaged, or
/// stand for more than 64 MiB.
std::optional<std::string> unpacked_text(std::string_view letters);

}  // namespace fumon
