#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>

#include "files/terrain/terrain_file.h"

namespace fumon {

namespace {

/// The shortest digits that read back as the same number.
template <class Number>
void append(std::string& text, Number value) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end);
}

template <class Number>
void append_line(std::string& text, std::string_view word, Number value) {
    text += word;
    text += ' ';
    append(text, value);
    text += '\n';
}

/// −9999, or the first of −99999, −999999 … that is no cell's height.
double unused_value(const Grid& heights) {
    double value = -9999.0;
    const auto cells = heights.values();
    while (std::find(cells.begin(), cells.end(), value) != cells.end()) value = value * 10.0 - 9.0;
    return value;
}

}  // namespace

std::string esri_ascii(const Grid& heights, const Mask& nodata, double dx, double dy) {
    constexpr std::size_t usual_cell = 20;  // characters: 17 digits, sign, point, space
    const double nodata_value = unused_value(heights);
    std::string text;
    text.reserve(usual_cell * heights.size() + 200);
    append_line(text, "ncols", heights.nx());
    append_line(text, "nrows", heights.ny());
    append_line(text, "xllcorner", 0.0);
    append_line(text, "yllcorner", 0.0);
    if (dx == dy) {
        append_line(text, "cellsize", dx);
    } else {
        append_line(text, "dx", dx);
        append_line(text, "dy", dy);
    }
    append_line(text, "NODATA_value", nodata_value);
    for (int y = heights.ny() - 1; y >= 0; --y) {
        for (int x = 0; x < heights.nx(); ++x) {
            if (x > 0) text += ' ';
            append(text, !nodata.empty() && nodata(x, y) != 0 ? nodata_value : heights(x, y));
        }
        text += '\n';
    }
    return text;
}

}  // namespace fumon
