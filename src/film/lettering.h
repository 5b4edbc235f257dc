#pragma once

#include <string>
#include <vector>

#include "base/image.h"
#include "figure/canvas/canvas.h"

namespace fumon {

/// The height of a capital letter of DejaVu Sans, font sizes.
inline constexpr double cap_height_em = 0.729;

/// Pixels of a picture's shorter side for which film.cap_height is meant.
inline constexpr double usual_side_pixels = 1080.0;

struct LetteredLine {
    std::string text;
    double font_size = 38.0;  ///< pixels
    bool bold = false;
};

/// Lines of white letters with a soft shadow, one below the other and centred, drawn once. A line
/// that is wider than there is room breaks between words, or between letters where a word is too
/// long (as Japanese is).
class Lettering {
  public:
    Lettering(const std::vector<LetteredLine>& lines, double widest);

    /// Of the letters, without their shadow, pixels.
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }
    /// Lays it over a picture, the middle of its upper edge at (middle, top).
    void draw(Image& image, double middle, double top, double opacity) const;
    /// One line for the user where no font has a letter; else empty.
    [[nodiscard]] const std::string& missing_letters() const { return missing_; }

  private:
    CanvasLayer layer_;
    double width_ = 0.0;
    double height_ = 0.0;
    int margin_ = 0;
    std::string missing_;
};

/// A text in lines no wider than `widest` pixels.
std::vector<std::string> broken_lines(const Canvas& ruler, const std::string& text, double size,
                                      bool bold, double widest);

}  // namespace fumon
