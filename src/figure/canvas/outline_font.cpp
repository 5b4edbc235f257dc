#include "figure/canvas/outline_font.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

#include "base/data_files.h"
#include "base/error.h"

namespace fumon {

namespace {

/// The words of a line, one after the other.
class Words {
  public:
    Words(std::string_view line, std::string_view source, int number)
        : line_(line), source_(source), number_(number) {}

    std::string_view next() {
        line_.remove_prefix(std::min(line_.find_first_not_of(' '), line_.size()));
        const auto length = std::min(line_.find(' '), line_.size());
        const std::string_view word = line_.substr(0, length);
        line_.remove_prefix(length);
        return word;
    }

    double number() {
        const std::string_view word = next();
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size()) fail(word);
        return value;
    }

    char32_t code() {
        const std::string_view word = next();
        std::uint32_t value = 0;
        const auto [end, error] =
            std::from_chars(word.data(), word.data() + word.size(), value, 16);
        if (error != std::errc{} || end != word.data() + word.size()) fail(word);
        return value;
    }

    [[noreturn]] void fail(std::string_view word) const {
        throw InputError(
            fmt::format("{}:{}: '{}' is not valid in a font file", source_, number_, word));
    }

  private:
    std::string_view line_;
    std::string_view source_;
    int number_;
};

LetterOutline read_letter(Words& words) {
    LetterOutline letter;
    letter.advance = words.number();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        OutlinePiece piece;
        if (word == "M" || word == "L") {
            piece.kind = word == "M" ? OutlinePiece::Kind::move : OutlinePiece::Kind::line;
            for (std::size_t i = 0; i < 2; ++i) piece.at[i] = words.number();
        } else if (word == "Q") {
            piece.kind = OutlinePiece::Kind::curve;
            for (double& coordinate : piece.at) coordinate = words.number();
        } else if (word != "Z") {
            words.fail(word);
        }
        letter.pieces.push_back(piece);
    }
    return letter;
}

std::uint64_t pair_of(char32_t left, char32_t right) {
    return (std::uint64_t{left} << 32U) | right;
}

OutlineFont read_font(std::string_view name) {
    const auto path = data_file(fmt::format("assets/fonts/{}.txt", name));
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return OutlineFont::parse(text, path.string());
}

}  // namespace

OutlineFont OutlineFont::parse(std::string_view text, std::string_view source) {
    OutlineFont font;
    for (int number = 1; !text.empty(); ++number) {
        const auto length = std::min(text.find('\n'), text.size());
        Words words(text.substr(0, length), source, number);
        text.remove_prefix(std::min(length + 1, text.size()));
        const std::string_view what = words.next();
        if (what.empty() || what.front() == '#') continue;
        if (what == "glyph") {
            const char32_t code = words.code();
            font.letters_[code] = read_letter(words);
        } else if (what == "kern") {
            const char32_t left = words.code();
            const char32_t right = words.code();
            font.kerning_[pair_of(left, right)] = words.number();
        } else if (what == "em") {
            font.units_ = words.number();
            if (words.next() != "ascent") words.fail(what);
            font.ascent_ = words.number();
            if (words.next() != "descent") words.fail(what);
            font.descent_ = words.number();
        } else {
            words.fail(what);
        }
    }
    if (!(font.units_ > 0.0) || !(font.ascent_ + font.descent_ > 0.0))
        throw InputError(
            fmt::format("{}: a line 'em UNITS ascent UNITS descent UNITS' is missing", source));
    return font;
}

const OutlineFont& OutlineFont::sans(bool bold) {
    static const OutlineFont regular_letters = read_font("dejavu-sans");
    if (!bold) return regular_letters;
    static const OutlineFont bold_letters = read_font("dejavu-sans-bold");
    return bold_letters;
}

const LetterOutline* OutlineFont::find(char32_t letter) const {
    const auto found = letters_.find(letter);
    return found == letters_.end() ? nullptr : &found->second;
}

double OutlineFont::kerning(char32_t left, char32_t right) const {
    const auto found = kerning_.find(pair_of(left, right));
    return found == kerning_.end() ? 0.0 : found->second;
}

}  // namespace fumon
