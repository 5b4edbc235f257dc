#include "figure/canvas/pdf_strings.h"

#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <memory>
#include <optional>

namespace fumon {

namespace {

constexpr std::string_view pdf_spaces("\0\t\n\f\r ", 6);

/// The bytes of "(…)", of which `text` starts with the bracket; none where it does not end.
std::optional<std::string> literal_bytes(std::string_view text) {
    std::string bytes;
    int depth = 1;
    for (std::size_t i = 1; i < text.size(); ++i) {
        char c = text[i];
        if (c == '(') ++depth;
        if (c == ')' && --depth == 0) return bytes;
        if (c == '\r') {  // a line's end is one character, whichever it was
            if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
            c = '\n';
        }
        if (c != '\\') {
            bytes += c;
            continue;
        }
        if (++i >= text.size()) break;
        constexpr std::string_view letters = "nrtbf";
        constexpr std::string_view meant = "\n\r\t\b\f";
        c = text[i];
        if (const std::size_t at = letters.find(c); at != std::string_view::npos) {
            bytes += meant[at];
        } else if (c >= '0' && c <= '7') {
            unsigned code = 0;
            std::size_t end = i;
            for (; end < std::min(i + 3, text.size()) && text[end] >= '0' && text[end] <= '7';
                 ++end)
                code = 8 * code + static_cast<unsigned>(text[end] - '0');
            bytes += static_cast<char>(code & 0xFFU);
            i = end - 1;
        } else if (c == '\r') {
            if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
        } else if (c != '\n') {
            bytes += c;
        }
    }
    return std::nullopt;
}

std::optional<std::string> hexadecimal_bytes(std::string_view text) {
    const std::size_t end = text.find('>');
    if (end == std::string_view::npos) return std::nullopt;
    std::string digits;
    for (const char c : text.substr(1, end - 1)) {
        if (pdf_spaces.find(c) == std::string_view::npos) digits += c;
    }
    if (digits.size() % 2 != 0) digits += '0';
    std::string bytes;
    constexpr int hexadecimal = 16;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        unsigned code = 0;
        const char* const begin = digits.data() + i;
        if (std::from_chars(begin, begin + 2, code, hexadecimal).ptr != begin + 2)
            return std::nullopt;
        bytes += static_cast<char>(code);
    }
    return bytes;
}

void add_utf8(std::string& text, unsigned code) {
    const auto add = [&text](unsigned byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0U | code >> 6U);
        add(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        add(0xE0U | code >> 12U);
        add(0x80U | (code >> 6U & 0x3FU));
        add(0x80U | (code & 0x3FU));
    } else {
        add(0xF0U | code >> 18U);
        add(0x80U | (code >> 12U & 0x3FU));
        add(0x80U | (code >> 6U & 0x3FU));
        add(0x80U | (code & 0x3FU));
    }
}

/// Of big-endian UTF-16.
std::string utf8_of_utf16(std::string_view bytes) {
    std::string text;
    const auto unit = [bytes](std::size_t at) {
        return static_cast<unsigned>(static_cast<unsigned char>(bytes[at])) << 8U |
               static_cast<unsigned char>(bytes[at + 1]);
    };
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        unsigned code = unit(i);
        const bool first = code >= 0xD800 && code < 0xDC00;
        if (first && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10U) + (unit(i + 2) - 0xDC00);
            i += 2;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = '?';
        }
        add_utf8(text, code);
    }
    return text;
}

}  // namespace

std::size_t pdf_space(std::string_view bytes) {
    return std::min(bytes.find_first_not_of(pdf_spaces), bytes.size());
}

std::string pdf_string(std::string_view bytes) {
    std::optional<std::string> string;
    if (bytes.starts_with('(')) string = literal_bytes(bytes);
    if (bytes.starts_with('<')) string = hexadecimal_bytes(bytes);
    if (!string) return "";
    constexpr std::string_view utf16_mark = "\xFE\xFF";
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    if (string->starts_with(utf16_mark)) return utf8_of_utf16(string->substr(2));
    if (string->starts_with(utf8_mark)) return string->substr(3);
    for (char& c : *string) {
        if (static_cast<unsigned char>(c) > 127) c = '?';
    }
    return std::move(*string);
}

std::optional<std::string> inflated(std::string_view bytes, std::size_t& most) {
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    if (!decompressor) return std::nullopt;
    constexpr std::size_t least_room = 1 << 14;
    std::size_t room = least_room;
    while (room <= most) {
        most -= room;
        std::string content(room, '\0');
        std::size_t taken = 0;
        std::size_t written = 0;
        const auto result = libdeflate_zlib_decompress_ex(
            decompressor.get(), bytes.data(), bytes.size(), content.data(), room, &taken, &written);
        if (result == LIBDEFLATE_SUCCESS) {
            content.resize(written);
            return content;
        }
        if (result != LIBDEFLATE_INSUFFICIENT_SPACE) break;
        room = std::max(room + 1, std::min(4 * room, most));
    }
    return std::nullopt;
}

PdfStreams pdf_streams(std::string_view pdf) {
    constexpr std::string_view begin = "stream";
    constexpr std::size_t longest_dictionary = 4096;
    std::size_t room = most_inflated;
    PdfStreams streams;
    for (std::size_t at = pdf.find(begin); at != std::string_view::npos;
         at = pdf.find(begin, at + begin.size())) {
        std::size_t from = at + begin.size();
        if (pdf.substr(from).starts_with("\r\n")) {
            from += 2;
        } else if (pdf.substr(from).starts_with('\n')) {
            from += 1;
        } else {
            continue;
        }
        const std::size_t earliest = at - std::min(at, longest_dictionary);
        std::string_view dictionary = pdf.substr(earliest, at - earliest);
        const std::size_t object = dictionary.rfind(" obj");
        if (object == std::string_view::npos) continue;  // "endstream" among others
        dictionary.remove_prefix(object);
        const auto has = [dictionary](std::string_view name) {
            return dictionary.find(name) != std::string_view::npos;
        };
        const bool holds_objects = has("/ObjStm");
        if (!holds_objects && !(has("/Metadata") && has("/XML"))) continue;
        std::string_view content = pdf.substr(from);
        std::string& to = holds_objects ? streams.objects : streams.xmp;
        if (has("/Filter")) {
            if (const auto text = inflated(content, room)) to += *text;
        } else {
            content = content.substr(0, content.find("endstream"));
            if (content.size() > room) continue;
            room -= content.size();
            to += content;
        }
        to += '\n';
    }
    return streams;
}

}  // namespace fumon
