#include "figure/canvas/outline_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "base/utf8.h"

namespace fumon {

namespace {

/// The letter that some bytes of well-formed UTF-8 begin with, which takes `length` of them.
char32_t letter_at(std::string_view bytes, std::size_t length) {
    const auto byte = [bytes](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (length == 1) return byte(0);
    char32_t letter = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) letter = (letter << 6U) | (byte(i) & 0x3FU);
    return letter;
}

}  // namespace

std::optional<OutlineText> OutlineText::set(const MarkedText& text, double size, bool bold) {
    const OutlineFont& font = OutlineFont::sans(bold);
    struct Line {
        std::size_t begin = 0;
        double length = 0.0;
        double above = 0.0;  ///< the base line
        double below = 0.0;
    };
    OutlineText set;
    std::vector<Line> lines(1);
    const auto reach = [&](double scale, double rise) {
        lines.back().above = std::max(lines.back().above, font.ascent() * scale + rise);
        lines.back().below = std::max(lines.back().below, font.descent() * scale - rise);
    };
    const double whole = size / font.units();
    char32_t before = 0;
    double scale_before = 0.0;
    auto part = text.parts.begin();
    const std::string_view bytes = text.letters;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length = utf8_length(bytes.substr(at));
        if (length == 0) return std::nullopt;
        const char32_t letter = letter_at(bytes.substr(at), length);
        while (part != text.parts.end() && part->end <= at) ++part;
        double scale = whole;
        double rise = 0.0;
        if (part != text.parts.end() && part->begin <= at) {
            scale *= RaisedLetters::size;
            rise = size * (part->raised ? RaisedLetters::raised : RaisedLetters::lowered);
        }
        at += length;
        if (letter == U'\n') {
            if (lines.back().above == 0.0) reach(whole, 0.0);
            lines.push_back({set.letters_.size()});
            before = 0;
            continue;
        }
        const LetterOutline* outline = font.find(letter);
        if (outline == nullptr) return std::nullopt;
        Line& line = lines.back();
        if (before != 0 && scale == scale_before)
            line.length += scale * font.kerning(before, letter);
        set.letters_.push_back({outline, line.length, -rise, scale});
        line.length += scale * outline->advance;
        reach(scale, rise);
        before = letter;
        scale_before = scale;
    }
    if (lines.back().above == 0.0) reach(whole, 0.0);
    for (const Line& line : lines) set.width_ = std::max(set.width_, line.length);
    for (std::size_t n = 0; n < lines.size(); ++n) {
        const std::size_t end = n + 1 < lines.size() ? lines[n + 1].begin : set.letters_.size();
        for (std::size_t i = lines[n].begin; i < end; ++i) {
            set.letters_[i].x += 0.5 * (set.width_ - lines[n].length);
            set.letters_[i].y += set.height_ + lines[n].above;
        }
        set.height_ += lines[n].above + lines[n].below;
    }
    return set;
}

void OutlineText::fill(cairo_t* drawing) const {
    double left = 0.0;
    double top = 0.0;
    cairo_get_current_point(drawing, &left, &top);
    cairo_new_path(drawing);
    cairo_matrix_t turn{};
    cairo_get_matrix(drawing, &turn);
    const bool level = turn.xy == 0.0 && turn.yx == 0.0 && turn.yy == 1.0;
    for (const Placed& letter : letters_) {
        // A base line between two rows of pixels would blur the feet of all letters.
        const double base =
            level ? std::floor(turn.y0 + top + letter.y + 0.5) - turn.y0 : top + letter.y;
        double x = 0.0;
        double y = 0.0;
        const auto place = [&](std::size_t first, const OutlinePiece& piece) {
            return std::pair{left + letter.x + letter.scale * piece.at[first],
                             base - letter.scale * piece.at[first + 1]};
        };
        for (const OutlinePiece& piece : letter.outline->pieces) {
            if (piece.kind == OutlinePiece::Kind::close) {
                cairo_close_path(drawing);
                continue;
            }
            const bool curve = piece.kind == OutlinePiece::Kind::curve;
            const auto [end_x, end_y] = place(curve ? 2 : 0, piece);
            if (curve) {  // the same curve as a cubic one
                const auto [middle_x, middle_y] = place(0, piece);
                constexpr double third = 1.0 / 3.0;
                cairo_curve_to(drawing, third * x + 2.0 * third * middle_x,
                               third * y + 2.0 * third * middle_y,
                               third * end_x + 2.0 * third * middle_x,
                               third * end_y + 2.0 * third * middle_y, end_x, end_y);
            } else if (piece.kind == OutlinePiece::Kind::line) {
                cairo_line_to(drawing, end_x, end_y);
            } else {
                cairo_move_to(drawing, end_x, end_y);
            }
            x = end_x;
            y = end_y;
        }
    }
    cairo_fill(drawing);
}

}  // namespace fumon
