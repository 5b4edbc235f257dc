#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace fumon {

/// A piece of a letter's outline: a line or a quadratic curve to a point, or the end of a contour.
struct OutlinePiece {
    enum class Kind : std::uint8_t { move, line, curve, close };
    Kind kind = Kind::close;
    std::array<double, 4> at{};  ///< x, y of the end; of a curve the control point's come before
};

/// A letter, in units of its font: y upwards from the base line.
struct LetterOutline {
    double advance = 0.0;  ///< from its beginning to that of the next letter
    std::vector<OutlinePiece> pieces;
};

/// A font's letters as outlines that fumon ships (assets/fonts), so that texts on frames have the
/// same pixels wherever they are drawn: no font, shaper or hinting of the system takes part.
class OutlineFont {
  public:
    /// Reads the text of a font's file, whose lines assets/fonts/README.md describes. Throws
    /// InputError with source and line where one is another.
    static OutlineFont parse(std::string_view text, std::string_view source);
    /// DejaVu Sans, read when it is first asked for. Throws Error where its file is missing.
    static const OutlineFont& sans(bool bold);

    /// The outline of a letter, or null where the font has none.
    [[nodiscard]] const LetterOutline* find(char32_t letter) const;
    /// What is added between two letters, in units of the font.
    [[nodiscard]] double kerning(char32_t left, char32_t right) const;

    [[nodiscard]] double units() const { return units_; }  ///< of a font size
    [[nodiscard]] double ascent() const { return ascent_; }
    [[nodiscard]] double descent() const { return descent_; }

  private:
    double units_ = 0.0;
    double ascent_ = 0.0;
    double descent_ = 0.0;
    std::unordered_map<char32_t, LetterOutline> letters_;
    std::unordered_map<std::uint64_t, double> kerning_;
};

}  // namespace fumon
