#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// The text of the PDF string that bytes start with, "(…)" or "<…>" (ISO 32000-1, 7.3.4), in UTF-8:
/// of UTF-16 or UTF-8 after their marks, and of ASCII; "?" for other bytes. Empty where the bytes
/// start with no string, or it does not end.
std::string pdf_string(std::string_view bytes);

/// Bytes to which what a file holds is inflated at most, altogether.
inline constexpr std::size_t most_inflated = std::size_t{64} << 20U;

/// What a deflated stream (RFC 1950) holds, whatever follows it; none where it is damaged, or
/// larger than `most`, which is lessened by the room that was taken.
std::optional<std::string> inflated(std::string_view bytes, std::size_t& most);

/// What a PDF file's object streams hold, and its XMP packets, inflated where they are deflated;
/// other streams are left out. Streams that are damaged or would inflate to more than 64 MiB
/// together are left out too.
struct PdfStreams {
    std::string objects;
    std::string xmp;
};
PdfStreams pdf_streams(std::string_view pdf);

/// The number of bytes of white space of a PDF file that bytes start with.
std::size_t pdf_space(std::string_view bytes);

}  // namespace fumon
