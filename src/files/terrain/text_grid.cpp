#include "files/terrain/text_grid.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "files/text_source.h"

namespace fumon {

namespace {

/// The words of a line, parted by spaces, commas or semicolons.
std::vector<std::string_view> words_of(std::string_view line) {
    const auto parts = [](char c) { return is_blank(c) || c == ',' || c == ';'; };
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
        if (parts(line[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < line.size() && !parts(line[end])) ++end;
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

/// The first lines that are neither empty nor comments.
std::vector<std::string_view> first_lines(std::string_view text) {
    constexpr std::size_t enough = 3;
    std::vector<std::string_view> lines;
    for (std::size_t at = 0; at < text.size() && lines.size() < enough;) {
        std::size_t end = at;
        while (end < text.size() && !is_line_end(text[end])) ++end;
        const std::string_view line = text.substr(at, end - at);
        if (!words_of(line).empty() && line.front() != '#') lines.push_back(line);
        at = end + 1;
    }
    return lines;
}

bool is_number(std::string_view word) {
    const ParsedNumber number = parse_number(word);
    return number.kind != NumberKind::none && number.length == word.size();
}

bool is_point(std::string_view line) {
    const auto words = words_of(line);
    return words.size() == 3 && std::ranges::all_of(words, is_number);
}

/// "x y z", "lon,lat,height" and the like.
bool is_heading(std::string_view line) {
    const auto words = words_of(line);
    if (words.size() != 3) return false;
    constexpr std::array<std::string_view, 6> eastward{"x",       "lon",  "longitude",
                                                       "easting", "east", "e"};
    std::string first;
    for (const char c : words.front()) {
        if (c == '"') continue;
        first += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return std::ranges::find(eastward, first) != eastward.end();
}

}  // namespace

std::optional<OtherTextGrid> other_text_grid(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (text.starts_with("DSAA")) {
        return OtherTextGrid{"a Surfer ASCII grid (DSAA)",
                             "make an ESRI ASCII grid or a GeoTIFF of it (gdal_translate -of "
                             "AAIGrid IN OUT.asc)"};
    }
    const auto lines = first_lines(text);
    if (lines.size() < 2) return std::nullopt;
    const bool is_list = is_point(lines[1]) && (is_point(lines[0]) || is_heading(lines[0]));
    if (!is_list) return std::nullopt;
    return OtherTextGrid{"a list of points (XYZ)",
                         "make a grid of it: gdal_translate -of AAIGrid IN OUT.asc of points that "
                         "fill an even grid, gdal_grid of scattered ones",
                         true};
}

}  // namespace fumon
