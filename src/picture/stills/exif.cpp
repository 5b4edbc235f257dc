#include "picture/stills/exif.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fumon {

namespace {

enum class Kind : std::uint16_t { short_number = 3, long_number = 4, ratio = 5, undefined = 7 };

void append_number(std::string& bytes, std::uint32_t number, int count) {
    for (; count > 0; --count, number >>= 8U) bytes += static_cast<char>(number & 0xFFU);
}

/// An entry of a directory: its tag, kind, count and value (or where its value stands).
void append_entry(std::string& bytes, std::uint16_t tag, Kind kind, std::uint32_t count,
                  std::uint32_t value) {
    append_number(bytes, tag, 2);
    append_number(bytes, static_cast<std::uint16_t>(kind), 2);
    append_number(bytes, count, 4);
    append_number(bytes, value, 4);
}

}  // namespace

std::string exif_block(double dots_per_inch, int width, int height) {
    constexpr std::uint32_t head = 8;
    constexpr std::uint32_t entries = 4;  // of each of the two directories
    constexpr std::uint32_t directory = 2 + 12 * entries + 4;
    constexpr std::uint32_t ratios = head + 2 * directory;
    constexpr std::uint32_t parts = 1000;  // of a dot
    const auto dots =
        static_cast<std::uint32_t>(std::round(std::clamp(dots_per_inch, 0.001, 4.0e6) * parts));
    std::string bytes("II*\0", 4);
    append_number(bytes, head, 4);
    append_number(bytes, entries, 2);
    append_entry(bytes, 0x011A, Kind::ratio, 1, ratios);    // XResolution
    append_entry(bytes, 0x011B, Kind::ratio, 1, ratios);    // YResolution
    append_entry(bytes, 0x0128, Kind::short_number, 1, 2);  // ResolutionUnit: an inch
    append_entry(bytes, 0x8769, Kind::long_number, 1, head + directory);
    append_number(bytes, 0, 4);
    append_number(bytes, entries, 2);
    append_entry(bytes, 0x9000, Kind::undefined, 4, 0x32333230);  // ExifVersion: "0232"
    append_entry(bytes, 0xA001, Kind::short_number, 1, 1);        // ColorSpace: sRGB
    append_entry(bytes, 0xA002, Kind::long_number, 1, static_cast<std::uint32_t>(width));
    append_entry(bytes, 0xA003, Kind::long_number, 1, static_cast<std::uint32_t>(height));
    append_number(bytes, 0, 4);
    append_number(bytes, dots, 4);
    append_number(bytes, parts, 4);
    return bytes;
}

}  // namespace fumon
