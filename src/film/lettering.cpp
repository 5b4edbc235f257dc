#include "film/lettering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "figure/canvas/layers.h"

namespace fumon {

namespace {

constexpr double line_gap_em = 0.28;     // of a line's font size, below it
constexpr double shadow_reach_em = 0.3;  // font sizes

/// The end of the letter that begins at a byte of UTF-8.
std::size_t letter_end(const std::string& text, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
    return end;
}

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

std::vector<std::string> broken_lines(const Canvas& ruler, const std::string& text, double size,
                                      bool bold, double widest) {
    std::vector<std::string> lines;
    std::string line;
    const auto fits = [&](const std::string& tried) {
        return ruler.text_size(tried, size, bold)[0] <= widest;
    };
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = letter_end(text, at);
        const std::string letter = text.substr(at, end - at);
        at = end;
        if (letter == "\n") {
            lines.push_back(trimmed(line));
            line.clear();
            continue;
        }
        if (line.empty() || letter == " " || fits(line + letter)) {
            line += letter;
            continue;
        }
        const std::size_t space = line.rfind(' ');
        const bool between_words = space != std::string::npos && space > 0;
        lines.push_back(trimmed(between_words ? line.substr(0, space) : line));
        line = between_words ? line.substr(space + 1) : "";
        line += letter;
    }
    lines.push_back(trimmed(line));
    return lines;
}

Lettering::Lettering(const std::vector<LetteredLine>& lines, double widest) {
    struct Placed {
        std::string text;
        double size;
        bool bold;
        double top;
    };
    const Canvas ruler(1, 1, 1.0);
    std::vector<Placed> placed;
    double largest = 1.0;
    double gap = 0.0;
    for (const LetteredLine& line : lines) {
        largest = std::max(largest, line.font_size);
        for (const std::string& text :
             broken_lines(ruler, line.text, line.font_size, line.bold, widest)) {
            const auto [width, height] =
                ruler.text_size(text.empty() ? " " : text, line.font_size, line.bold);
            height_ += gap;
            placed.push_back({text, line.font_size, line.bold, height_});
            width_ = std::max(width_, width);
            height_ += height;
            gap = line_gap_em * line.font_size;
        }
    }
    margin_ = static_cast<int>(std::ceil(shadow_reach_em * largest)) + 2;
    Canvas canvas(static_cast<int>(std::ceil(width_)) + 2 * margin_,
                  static_cast<int>(std::ceil(height_)) + 2 * margin_, 1.0,
                  CanvasGround::transparent);
    for (const Placed& line : placed) {
        if (line.text.empty()) continue;
        canvas.write(line.text, {0.5 * canvas.width(), margin_ + line.top}, {0.5, 0.0}, white_ink,
                     line.size, false, line.bold);
    }
    missing_ = canvas.missing_letters();
    layer_ = with_soft_shadow(canvas.layer(), margin_);
}

void Lettering::draw(Image& image, double middle, double top, double opacity) const {
    composite_over(image, layer_, static_cast<int>(std::lround(middle - 0.5 * layer_.width)),
                   static_cast<int>(std::lround(top)) - margin_, opacity);
}

}  // namespace fumon
