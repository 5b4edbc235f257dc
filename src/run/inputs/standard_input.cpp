#include "run/inputs/standard_input.h"

#include <unistd.h>

#include <array>
#include <cstdio>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "files/text_source.h"

namespace fumon {

namespace {

constexpr const char* name_of_input = "standard input";

std::string all_bytes() {
    if (::isatty(STDIN_FILENO) != 0) {
        throw InputError(
            "-: standard input is a terminal; redirect a file or pipe a program into it (< "
            "my.toml)");
    }
    std::string bytes;
    std::array<char, 1 << 16> piece{};
    for (std::size_t read = 0; (read = std::fread(piece.data(), 1, piece.size(), stdin)) > 0;) {
        bytes.append(piece.data(), read);
        if (bytes.size() > static_cast<std::size_t>(largest_input_file))
            throw InputError("-: standard input does not end within 4 GiB; name a file");
    }
    if (std::ferror(stdin) != 0) throw InputError("-: standard input cannot be read; name a file");
    if (bytes.empty()) {
        throw InputError(
            "-: standard input is empty; it takes a scene (TOML) or a file of terrain");
    }
    return bytes;
}

char small_letter(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// The first word of a grid's header, in small letters.
std::string first_word(std::string_view bytes) {
    std::string word;
    for (const char letter : bytes) {
        if (is_space(letter)) {
            if (word.empty()) continue;
            break;
        }
        word += small_letter(letter);
        constexpr std::size_t longest = 16;
        if (word.size() > longest) break;
    }
    return word;
}

}  // namespace

bool is_standard_input(const std::string& given) {
    return given == "-";
}

std::string_view terrain_ending_of(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89PNG"sv)) return ".png";
    if (bytes.starts_with("\x89HDF"sv) || bytes.starts_with("CDF"sv)) return ".nc";
    if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) ||
        bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv))
        return ".tif";
    for (const std::string_view word :
         {"ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize"}) {
        if (first_word(bytes) == word) return ".asc";
    }
    return {};
}

StandardInput::StandardInput() : bytes_(all_bytes()) {
    const std::string_view ending = terrain_ending_of(bytes_);
    if (ending.empty()) return;
    folder_ = std::make_unique<ScratchFolder>();
    terrain_ = folder_->path() / ("standard-input" + std::string(ending));
    write_file(terrain_, bytes_);
}

SceneText StandardInput::scene() const {
    SceneText text;
    text.text = bytes_;
    text.source = name_of_input;
    return text;
}

const std::filesystem::path& StandardInput::terrain() const {
    if (is_scene()) {
        throw InputError(
            "-: standard input is not terrain of a known format; it takes an ESRI ASCII grid, a "
            "NetCDF file, a GeoTIFF or a PNG");
    }
    return terrain_;
}

}  // namespace fumon
