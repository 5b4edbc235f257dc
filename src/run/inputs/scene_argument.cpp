#include "run/inputs/scene_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr std::array argument_folders{"scenes/", "scenes/figures/"};

/// The names of scenes that may be given alone.
std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    for (const char* folder : argument_folders) {
        const auto place = find_data_file(folder);
        if (!place) continue;
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(*place, fault)) {
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
        }
    }
    std::ranges::sort(names);
    return names;
}

bool is_bare_name(const std::string& given) {
    return !given.empty() && !fs::path(given).has_parent_path() && given != "." && given != "..";
}

}  // namespace

std::string scene_argument(const std::string& given) {
    const fs::path path = given;
    std::error_code fault;
    if (!is_bare_name(given) || fs::is_regular_file(path, fault)) return given;
    const bool is_word = path.extension() != ".toml";
    const std::string file = is_word ? given + ".toml" : given;
    for (const char* folder : argument_folders) {
        if (const auto shipped = find_data_file(folder + file)) return shipped->string();
    }
    if (!is_word || path.has_extension() || fs::exists(path, fault)) return given;
    if (find_data_file("scenes/films/" + file)) {
        throw InputError(
            fmt::format("{}: is a film, not a scene; a film is cut from a run: fumon film RUN {}",
                        given, given));
    }
    const std::vector<std::string> names = shipped_names();
    if (names.empty()) static_cast<void>(data_file("scenes"));  // says where they were looked for
    const std::string nearest = nearest_name(given, names);
    throw InputError(
        nearest.empty()
            ? fmt::format("{}: there is no such file here, and fumon ships no such scene; name a "
                          "scene file (TOML)",
                          given)
            : fmt::format("{}: there is no such file here, and fumon ships no such scene; did you "
                          "mean \"{}\"?",
                          given, nearest));
}

bool is_scene_argument(const fs::path& given) {
    std::error_code fault;
    return given.extension() == ".toml" || (!given.has_extension() && !fs::exists(given, fault));
}

std::string terrain_argument(const std::string& given) {
    std::error_code fault;
    if (!is_bare_name(given) || fs::exists(given, fault)) return given;
    const auto shipped = find_data_file("assets/terrain/" + given);
    return shipped ? shipped->string() : given;
}

}  // namespace fumon
