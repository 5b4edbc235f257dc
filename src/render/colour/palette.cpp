#include "render/colour/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include "base/data_files.h"
#include "base/error.h"
#include "scene/view/palette_names.h"

namespace fumon {

namespace {

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
                "{}: '{}' is not a colour; three whole numbers 0 … 255 are expected", where, line));
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

Palette read_palette(std::string_view name) {
    check_palette_name(name);
    const auto file = data_file(fmt::format("assets/palettes/{}.txt", name));
    std::ifstream stream(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream || text.empty()) throw Error(fmt::format("{}: cannot be read", file.string()));
    return parse_palette(text, file.string());
}

}  // namespace fumon
