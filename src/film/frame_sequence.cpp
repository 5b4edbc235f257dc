#include "film/frame_sequence.h"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <optional>
#include <system_error>

#include "files/input_file.h"
#include "outputs/output_claims.h"

namespace fumon {

namespace {

/// Where the number stands in a name.
struct NumberPlace {
    std::size_t begin = 0;
    std::size_t length = 0;
    int digits = 1;
};

/// "%d", or "%0" with the number of digits, one to nine, and "d".
std::optional<NumberPlace> place_at(const std::string& name, std::size_t begin) {
    if (name.compare(begin, 2, "%d") == 0) return NumberPlace{begin, 2, 1};
    constexpr std::size_t padded = 4;
    if (name.size() < begin + padded || name.compare(begin, 2, "%0") != 0) return std::nullopt;
    const char digit = name[begin + 2];
    if (digit < '1' || digit > '9' || name[begin + 3] != 'd') return std::nullopt;
    return NumberPlace{begin, padded, digit - '0'};
}

std::optional<NumberPlace> number_place(const std::string& name) {
    std::optional<NumberPlace> found;
    for (std::size_t begin = name.find('%'); begin != std::string::npos;
         begin = name.find('%', begin + 1)) {
        const std::optional<NumberPlace> place = place_at(name, begin);
        if (!place || found) return std::nullopt;
        found = place;
    }
    return found;
}

}  // namespace

bool is_frame_sequence(const std::filesystem::path& file) {
    return number_place(file.filename().string()).has_value();
}

bool holds_light(const std::filesystem::path& file) {
    return small_ending(file) == ".exr";
}

std::filesystem::path sequence_name(const std::filesystem::path& file) {
    std::error_code fault;
    const bool is_folder = !file.has_filename() || std::filesystem::is_directory(file, fault);
    return is_folder && !file.empty() ? file / "frame_%05d.png" : file;
}

std::filesystem::path sequence_file(const std::filesystem::path& file, std::int64_t frame) {
    std::string name = file.filename().string();
    if (const std::optional<NumberPlace> place = number_place(name))
        name.replace(place->begin, place->length, fmt::format("{:0{}}", frame, place->digits));
    return file.parent_path() / name;
}

}  // namespace fumon
