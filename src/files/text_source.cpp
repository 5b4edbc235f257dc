#include "files/text_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/error.h"

namespace fumon {

namespace {

/// Microsoft's C library writes "-1.#IND", "1.#QNAN" and "1.#INF".
ParsedNumber parse_microsoft_special(std::string_view word) {
    const std::string_view kind = word.substr(word.find('#') + 1);
    if (kind.starts_with("INF")) return {NumberKind::infinite, 0.0, word.size()};
    if (kind.starts_with("QNAN") || kind.starts_with("SNAN") || kind.starts_with("IND"))
        return {NumberKind::not_a_number, 0.0, word.size()};
    return {};
}

/// from_chars gives one error for numbers too large and too small; the decimal exponent of the
/// first digit that is not zero tells them apart.
bool is_tiny(std::string_view number) {
    const std::size_t mark = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, mark);
    const std::size_t first = digits.find_first_of("123456789");
    const std::size_t point = std::min(digits.find('.'), digits.size());
    if (first == std::string_view::npos) return true;
    const long long exponent = static_cast<long long>(point) - static_cast<long long>(first);
    if (mark != std::string_view::npos) {
        std::string_view power = number.substr(mark + 1);
        const bool negative = power.starts_with('-');
        if (power.starts_with('+')) power.remove_prefix(1);
        long long written = 0;
        const auto result = std::from_chars(power.data(), power.data() + power.size(), written);
        if (result.ec != std::errc{}) return negative;
        return written < -exponent;  // whose sum may be too large for a number
    }
    return exponent < 0;
}

}  // namespace

void TextSource::fail(std::size_t offset, std::string_view what, std::string_view remedy) const {
    throw InputError(fmt::format("{}:{}: {}; {}", name, line_of(text, offset), what, remedy));
}

void TextSource::fail_at_column(std::size_t offset, std::string_view what,
                                std::string_view remedy) const {
    throw InputError(fmt::format("{}:{}:{}: {}; {}", name, line_of(text, offset),
                                 column_of(text, offset), what, remedy));
}

std::size_t line_of(std::string_view text, std::size_t offset) {
    std::size_t line = 1;
    const std::size_t end = std::min(offset, text.size());
    for (std::size_t i = 0; i < end; ++i) {
        const bool second_of_pair = text[i] == '\n' && i > 0 && text[i - 1] == '\r';
        if (is_line_end(text[i]) && !second_of_pair) ++line;
    }
    return line;
}

std::size_t column_of(std::string_view text, std::size_t offset) {
    std::size_t start = std::min(offset, text.size());
    const std::size_t end = start;
    while (start > 0 && !is_line_end(text[start - 1])) --start;
    return end - start + 1;
}

std::string_view word_at(std::string_view text, std::size_t offset) {
    std::size_t end = offset;
    while (end < text.size() && !is_space(text[end])) ++end;
    return text.substr(offset, end - offset);
}

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 40;
    return fmt::format("'{}{}'", one_line(std::string(word.substr(0, longest))),
                       word.size() > longest ? "…" : "");
}

ParsedNumber parse_number(std::string_view text) {
    const char* const end = text.data() + text.size();
    const char* begin = text.data();
    if (begin != end && *begin == '+') {
        ++begin;
        if (begin != end && *begin == '-') return {};
    }
    double value = 0.0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::invalid_argument) return {};
    const auto length = static_cast<std::size_t>(stop - text.data());
    if (stop != end && !is_space(*stop))
        return *stop == '#' ? parse_microsoft_special(word_at(text, 0)) : ParsedNumber{};
    if (error == std::errc::result_out_of_range) {
        if (!is_tiny(text.substr(0, length))) return {NumberKind::infinite, 0.0, length};
        return {NumberKind::finite, text.starts_with('-') ? -0.0 : 0.0, length};
    }
    if (std::isnan(value)) return {NumberKind::not_a_number, 0.0, length};
    if (std::isinf(value)) return {NumberKind::infinite, 0.0, length};
    return {NumberKind::finite, value, length};
}

}  // namespace fumon
