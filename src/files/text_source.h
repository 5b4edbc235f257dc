#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fumon {

/// The text of a file together with its name, so that whoever reads it can say where it is wrong.
struct TextSource {
    std::string name;
    std::string_view text;

    /// Throws InputError "name:line: what; remedy", where line is that of the character at
    /// `offset`.
    [[noreturn]] void fail(std::size_t offset, std::string_view what,
                           std::string_view remedy) const;

    /// The same as "name:line:column: what; remedy".
    [[noreturn]] void fail_at_column(std::size_t offset, std::string_view what,
                                     std::string_view remedy) const;
};

/// Counted from 1. CR, LF and CRLF each end a line.
std::size_t line_of(std::string_view text, std::size_t offset);

/// The place of a character in its line, counted from 1 in bytes.
std::size_t column_of(std::string_view text, std::size_t offset);

inline bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
inline bool is_space(char c) {
    return is_blank(c) || is_line_end(c);
}

/// The text from `offset` up to the next space or the end.
std::string_view word_at(std::string_view text, std::size_t offset);

/// A word as an error line can show it: in quotes, cut to 40 characters, see one_line().
std::string shown(std::string_view word);

enum class NumberKind { finite, not_a_number, infinite, none };

/// What stands at the start of some text: its kind, its value where finite, and how many characters
/// it takes. `none`: not a number up to the next space or the end.
struct ParsedNumber {
    NumberKind kind = NumberKind::none;
    double value = 0.0;
    std::size_t length = 0;
};

/// Decimal numbers as the C locale has them, with a leading '+' allowed, correctly rounded. "nan"
/// in every spelling (Microsoft's "1.#QNAN" too); a number beyond the largest double is infinite.
ParsedNumber parse_number(std::string_view text);

}  // namespace fumon
