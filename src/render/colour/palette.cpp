#include "render/colour/palette.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/data_files.h"
#include "base/error.h"

namespace fumon {

namespace {

/// How many letters must be changed, added or dropped to make one word of the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j + 1] + 1, row[j] + 1});
        }
    }
    return row.back();
}

std::array<std::uint8_t, 3> parse_colour(std::string_view line, const std::string& where) {
    std::array<std::uint8_t, 3> colour{};
    const char* place = line.data();
    const char* end = line.data() + line.size();
    for (std::uint8_t& channel : colour) {
        while (place != end && (*place == ' ' || *place == '\t')) ++place;
        int value = -1;
        const auto [rest, error] = std::from_chars(place, end, value);
        if (error != std::errc{} || value < 0 || value > 255) {
            throw InputError(fmt::format(
                "{}: '{}' is no colour; three whole numbers 0 … 255 are expected", where, line));
        }
        channel = static_cast<std::uint8_t>(value);
        place = rest;
    }
    if (place != end) {
        throw InputError(
            fmt::format("{}: '{}' has more than the three numbers of a colour", where, line));
    }
    return colour;
}

}  // namespace

Palette parse_palette(std::string_view text, std::string_view source) {
    Palette palette{};
    std::size_t count = 0;
    for (int number = 1; !text.empty(); ++number) {
        const auto length = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, length);
        text.remove_prefix(std::min(length + 1, text.size()));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        if (line.empty() || line.front() == '#') continue;
        const std::string where = fmt::format("{}:{}", source, number);
        const auto colour = parse_colour(line, where);
        if (count == palette.size())
            throw InputError(fmt::format("{}: a palette ends after 256 colours", where));
        palette[count++] = colour;
    }
    if (count != palette.size())
        throw InputError(fmt::format("{}: {} colours; a palette has 256", source, count));
    return palette;
}

std::vector<std::string> palette_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_file("assets/palettes"))) {
        if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Palette read_palette(std::string_view name) {
    const std::vector<std::string> names = palette_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const auto nearest =
            std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
                return edit_distance(name, a) < edit_distance(name, b);
            });
        throw InputError(fmt::format("unknown palette '{}'; did you mean '{}'? ({})", name,
                                     nearest != names.end() ? *nearest : "",
                                     fmt::join(names, ", ")));
    }
    const auto file = data_file(fmt::format("assets/palettes/{}.txt", name));
    std::ifstream stream(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream || text.empty()) throw Error(fmt::format("{}: cannot be read", file.string()));
    return parse_palette(text, file.string());
}

}  // namespace fumon
