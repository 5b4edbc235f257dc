#include "cli/scene_argument.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "cli/shipped_scenes.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// The names of scenes that a command may be given alone.
std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    for (const ShippedScene& scene : shipped_scenes({"", "figures"}))
        names.push_back(scene.file.stem().string());
    return names;
}

}  // namespace

std::string scene_argument(const std::string& given) {
    const fs::path path = given;
    std::error_code fault;
    const bool bare = !given.empty() && !path.has_parent_path() && given != "." && given != "..";
    if (!bare || fs::is_regular_file(path, fault)) return given;
    const bool is_word = path.extension() != ".toml";
    const std::string file = is_word ? given + ".toml" : given;
    for (const char* folder : {"scenes/", "scenes/figures/"}) {
        if (const auto shipped = find_data_file(folder + file)) return shipped->string();
    }
    if (!is_word || path.has_extension() || fs::exists(path, fault)) return given;
    const std::string nearest = nearest_name(given, shipped_names());
    throw InputError(
        nearest.empty()
            ? fmt::format("{}: there is no such file here, and fumon ships no such scene; name a "
                          "scene file (TOML)",
                          given)
            : fmt::format("{}: there is no such file here, and fumon ships no such scene; did you "
                          "mean \"{}\"?",
                          given, nearest));
}

}  // namespace fumon
