#pragma once

#include <cairo.h>

#include <optional>
#include <vector>

#include "figure/canvas/marked_text.h"
#include "figure/canvas/outline_font.h"

namespace fumon {

/// How letters are raised and lowered by marks (figure/canvas/marked_text.h).
struct RaisedLetters {
    static constexpr double size = 0.7;      ///< of the font size
    static constexpr double raised = 0.35;   ///< by how much, of the font size
    static constexpr double lowered = -0.2;  ///< likewise
};

/// A text set in outlines that fumon ships, its lines centred one below another.
class OutlineText {
  public:
    /// Sets a text of a font size in pixels, or gives none where the font lacks one of its letters.
    static std::optional<OutlineText> set(const MarkedText& text, double size, bool bold);

    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }
    /// Fills the letters with the colour in use, from the current point, which is the upper left
    /// corner.
    void fill(cairo_t* drawing) const;

  private:
    struct Placed {
        const LetterOutline* outline;
        double x;      ///< of its beginning, in pixels from the left
        double y;      ///< of its base line, in pixels from the top
        double scale;  ///< pixels of a unit of the font
    };
    std::vector<Placed> letters_;
    double width_ = 0.0;
    double height_ = 0.0;
};

}  // namespace fumon
