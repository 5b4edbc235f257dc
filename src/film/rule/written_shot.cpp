#include "film/rule/written_shot.h"

#include <fmt/format.h>

#include <algorithm>

namespace fumon {

std::string written_number(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (digits > 0) {
        while (text.ends_with('0')) text.pop_back();
        if (text.ends_with('.')) text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string quoted_text(const std::string& text) {
    constexpr unsigned char first_printed = 0x20;
    std::string quoted = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') quoted += '\\';
        if (static_cast<unsigned char>(letter) >= first_printed) quoted += letter;
    }
    return quoted + '"';
}

std::string without_placeholders(const std::string& text) {
    std::string plain;
    for (const char letter : text) plain.append(letter == '{' || letter == '}' ? 2 : 1, letter);
    return plain;
}

void WrittenShot::set(const std::string& key, const std::string& value) {
    const auto found = std::ranges::find(keys, key, &std::pair<std::string, std::string>::first);
    if (found == keys.end()) {
        keys.emplace_back(key, value);
    } else {
        found->second = value;
    }
}

void WrittenShot::set(const std::string& key, double value, int digits) {
    set(key, written_number(value, digits));
}

std::string WrittenShot::text() const {
    std::string lines = fmt::format("[[shot]]{}{}\n", comment.empty() ? "" : "  # ", comment);
    for (const auto& [key, value] : keys) lines += fmt::format("{} = {}\n", key, value);
    return lines;
}

}  // namespace fumon
