#include "picture/fingerprint_text.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "base/error.h"
#include "files/text_source.h"

namespace fumon {

namespace {

constexpr double largest_level = 255.0;
constexpr const char* remedy = "write the fingerprint again";

/// Exactly `digits` hexadecimal digits as bytes of 8 bits.
template <class Take>
void read_hexadecimal(const std::string& key, const std::string& text, std::size_t digits,
                      const Take& take) {
    const auto refuse = [&] {
        throw KeyError(key, fmt::format("{} takes {} hexadecimal digits; {}", key, digits, remedy));
    };
    if (text.size() != digits) refuse();
    for (std::size_t i = 0; i < digits; i += 2) {
        std::uint8_t byte = 0;
        const char* end = text.data() + i + 2;
        const auto [stop, fault] = std::from_chars(text.data() + i, end, byte, 16);
        if (fault != std::errc{} || stop != end) refuse();
        take(byte);
    }
}

void read_rows(const std::string& key, const std::vector<std::string>& rows, int channel,
               Thumbnail& thumbnail) {
    const auto refuse = [&] {
        throw KeyError(key, fmt::format("{} takes {} rows of {} levels from 0 to 255; {}", key,
                                        Thumbnail::height, Thumbnail::width, remedy));
    };
    if (rows.size() != Thumbnail::height) refuse();
    for (int y = 0; y < Thumbnail::height; ++y) {
        std::string_view left = rows[static_cast<std::size_t>(y)];
        for (int x = 0; x < Thumbnail::width; ++x) {
            while (!left.empty() && is_space(left.front())) left.remove_prefix(1);
            const ParsedNumber number = parse_number(left);
            if (number.kind != NumberKind::finite || number.value < 0.0 ||
                number.value > largest_level)
                refuse();
            thumbnail.at(x, y, channel) = number.value;
            left.remove_prefix(number.length);
        }
        while (!left.empty() && is_space(left.front())) left.remove_prefix(1);
        if (!left.empty()) refuse();
    }
}

std::string rows_text(const char* name, const Thumbnail& thumbnail, int channel) {
    std::string text = fmt::format("{} = [\n", name);
    for (int y = 0; y < Thumbnail::height; ++y) {
        text += "  \"";
        for (int x = 0; x < Thumbnail::width; ++x) {
            if (x > 0) text += ' ';
            text += fmt::format("{:5.1f}", thumbnail.at(x, y, channel));
        }
        text += "\",\n";
    }
    return text + "]\n";
}

}  // namespace

void FingerprintText::list_keys(const std::string& prefix, KeyTable& table) {
    table.integer_list(
        prefix + "size", size,
        {.unit = "pixels", .range = {1, 65535}, .help = "width and height of the picture"});
    table.text(prefix + "pixels", pixels, {.help = "SHA-256 of its pixels"});
    table.text(prefix + "dhash", dhash, {.help = "a label that similar pictures share"});
    const char* help = "rows of the thumbnail's levels";
    table.text_list(prefix + "red", red, {.help = help});
    table.text_list(prefix + "green", green, {.help = help});
    table.text_list(prefix + "blue", blue, {.help = help});
}

Fingerprint FingerprintText::fingerprint() const {
    Fingerprint fingerprint;
    if (size.size() != 2) throw KeyError("size", "size takes [width, height]");
    fingerprint.width = static_cast<int>(size[0]);
    fingerprint.height = static_cast<int>(size[1]);
    std::size_t next = 0;
    read_hexadecimal("pixels", pixels, 2 * fingerprint.pixels.size(),
                     [&](std::uint8_t byte) { fingerprint.pixels[next++] = byte; });
    read_hexadecimal("dhash", dhash, 16, [&](std::uint8_t byte) {
        fingerprint.difference_hash = (fingerprint.difference_hash << 8U) | byte;
    });
    read_rows("red", red, 0, fingerprint.thumbnail);
    read_rows("green", green, 1, fingerprint.thumbnail);
    read_rows("blue", blue, 2, fingerprint.thumbnail);
    return fingerprint;
}

std::string dhash_text(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

std::string fingerprint_text(const Fingerprint& fingerprint) {
    return fmt::format("size = [{}, {}]\npixels = \"{}\"\ndhash = \"{}\"\n", fingerprint.width,
                       fingerprint.height, hex(fingerprint.pixels),
                       dhash_text(fingerprint.difference_hash)) +
           rows_text("red", fingerprint.thumbnail, 0) +
           rows_text("green", fingerprint.thumbnail, 1) +
           rows_text("blue", fingerprint.thumbnail, 2);
}

}  // namespace fumon
