#include "drape/picture_place.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/input_file.h"
#include "files/terrain/prj_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_note = 1U << 20U;  // bytes of a world file or of GDAL's notes

bool is_there(const fs::path& file) {
    std::error_code fault;
    return fs::is_regular_file(file, fault);
}

/// "picture.pgw", "picture.pngw" or "picture.wld" of picture.png.
std::optional<fs::path> world_file_of(const fs::path& picture) {
    const std::string ending = picture.extension().string();
    std::vector<std::string> endings;
    if (ending.size() > 2)
        endings = {std::string{'.', ending[1], ending.back(), 'w'}, ending + 'w'};
    endings.emplace_back(".wld");
    for (const std::string& beside : endings) {
        fs::path file = picture;
        file.replace_extension(beside);
        if (is_there(file)) return file;
    }
    return std::nullopt;
}

std::array<double, 6> numbers_of(const fs::path& file) {
    const std::string text = start_of_input_file(file, longest_note);
    std::array<double, 6> numbers{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (double& number : numbers) {
        while (at != end && (std::isspace(static_cast<unsigned char>(*at)) != 0 || *at == '+'))
            ++at;
        const auto [next, fault] = std::from_chars(at, end, number);
        if (fault != std::errc{} || !std::isfinite(number)) {
            throw InputError(fmt::format(
                "{}: is not a world file; it takes six numbers: the pixel's size and turn, and the "
                "place of the middle of the upper left pixel",
                file.string()));
        }
        at = next;
    }
    return numbers;
}

/// The reference system in GDAL's notes of a picture; empty where they have none.
std::string crs_noted(const fs::path& picture) {
    const fs::path notes = picture.string() + ".aux.xml";
    if (!is_there(notes)) return {};
    const std::string text = start_of_input_file(notes, longest_note);
    const std::size_t tag = text.find("<SRS");
    const std::size_t begin = tag == std::string::npos ? tag : text.find('>', tag);
    const std::size_t end = begin == std::string::npos ? begin : text.find("</SRS>", begin);
    if (end == std::string::npos) return {};
    std::string crs = text.substr(begin + 1, end - begin - 1);
    using namespace std::string_view_literals;
    for (const auto& [entity, letter] : {std::pair{"&quot;"sv, "\""sv},
                                         {"&apos;"sv, "'"sv},
                                         {"&lt;"sv, "<"sv},
                                         {"&gt;"sv, ">"sv},
                                         {"&amp;"sv, "&"sv}}) {
        for (std::size_t at = 0; (at = crs.find(entity, at)) != std::string::npos; ++at)
            crs.replace(at, entity.size(), letter);
    }
    return crs;
}

}  // namespace

std::optional<PicturePlace> place_beside(const fs::path& picture) {
    const auto file = world_file_of(picture);
    if (!file) return std::nullopt;
    // Those of columns, then of rows, then of the middle of the first pixel.
    const auto [ax, ay, bx, by, x, y] = numbers_of(*file);
    if (ax * by - ay * bx == 0.0)
        throw InputError(fmt::format("{}: its pixels have no size", file->string()));
    PicturePlace place;
    place.transform = {x - 0.5 * (ax + bx), ax, bx, y - 0.5 * (ay + by), ay, by};
    Terrain nobody;  // whose note nobody reads
    place.crs = crs_beside(picture, nobody);
    if (place.crs.empty()) place.crs = crs_noted(picture);
    return place;
}

}  // namespace fumon
