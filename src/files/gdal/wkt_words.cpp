#include "files/gdal/wkt_words.h"

#include <array>
#include <cctype>
#include <charconv>

namespace fumon {

namespace {

std::string upper_case(std::string_view text) {
    std::string upper(text);
    for (char& letter : upper)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return upper;
}

/// Where the brackets close that open after `from`.
std::size_t end_of_brackets(std::string_view text, std::size_t from) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = from; at < text.size(); ++at) {
        if (text[at] == '"') quoted = !quoted;
        if (quoted) continue;
        if (text[at] == '[' || text[at] == '(') ++depth;
        if ((text[at] == ']' || text[at] == ')') && --depth == 0) return at + 1;
    }
    return text.size();
}

/// The last unit of length that is a direct part of a projected system, or of its axes.
void read_unit(std::string_view system, WktWords& words) {
    const std::string upper = upper_case(system);
    for (std::size_t at = 0; (at = upper.find("UNIT[", at)) != std::string::npos; at += 5) {
        const bool angle = at >= 5 && upper.substr(at - 5, 5) == "ANGLE";
        const bool scale = at >= 5 && upper.substr(at - 5, 5) == "SCALE";
        const std::size_t name = system.find('"', at);
        const std::size_t end = name == std::string_view::npos ? name : system.find('"', name + 1);
        if (angle || scale || end == std::string_view::npos) continue;
        const std::size_t number = system.find_first_of("0123456789.", end + 1);
        if (number == std::string_view::npos) continue;
        double factor = 0.0;
        std::from_chars(system.data() + number, system.data() + system.size(), factor);
        const std::string unit(system.substr(name + 1, end - name - 1));
        if (!(factor > 0.0) || upper_case(unit).starts_with("DEGREE")) continue;
        words.metres = factor;
        words.unit = unit;
    }
}

}  // namespace

WktWords wkt_words(std::string_view wkt) {
    const std::string upper = upper_case(wkt);
    constexpr std::array projected{"PROJCS[", "PROJCRS[", "PROJECTEDCRS["};
    constexpr std::array geographic{"GEOGCS[", "GEOGCRS[", "GEODCRS[", "GEOGRAPHICCRS[",
                                    "GEODETICCRS["};
    WktWords words;
    for (const char* word : projected) {
        const std::size_t begin = upper.find(word);
        if (begin == std::string::npos) continue;
        words.projected = true;
        const std::size_t end = end_of_brackets(wkt, begin);
        read_unit(wkt.substr(begin, end - begin), words);
        const std::string system = upper.substr(begin, end - begin);
        words.utm = system.find("UTM ZONE") != std::string::npos ||
                    system.find("UTM_ZONE") != std::string::npos;
        words.mercator = system.find("MERCATOR") != std::string::npos &&
                         system.find("TRANSVERSE") == std::string::npos &&
                         system.find("OBLIQUE") == std::string::npos;
        return words;
    }
    for (const char* word : geographic)
        words.geographic = words.geographic || upper.find(word) != std::string::npos;
    return words;
}

}  // namespace fumon
