#include "scene/text/scene_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

SceneText read_scene_text(const std::filesystem::path& file) {
    std::error_code fault;
    if (std::filesystem::is_directory(file, fault)) {
        throw InputError(fmt::format("{}: is a folder; a scene is a TOML file", file.string()));
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse_to_read(file, errno);
    constexpr std::size_t largest_scene = std::size_t{1} << 24;  // bytes; a device may have no end
    constexpr std::size_t piece = std::size_t{1} << 16;          // read at once
    std::string text;
    while (stream && text.size() <= largest_scene) {
        const std::size_t before = text.size();
        text.resize(before + piece);
        stream.read(text.data() + before, static_cast<std::streamsize>(piece));
        text.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) refuse_to_read(file, EIO);
    if (text.size() > largest_scene) {
        throw InputError(fmt::format("{}: has more than {} bytes; a scene is a TOML file",
                                     file.string(), largest_scene));
    }
    return {std::move(text), file.string(), file.parent_path()};
}

}  // namespace fumon
