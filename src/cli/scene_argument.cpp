#include "cli/scene_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// The folders of shipped scenes that there are.
std::vector<fs::path> shipped_folders() {
    std::vector<fs::path> folders;
    for (const char* name : {"scenes", "scenes/figures"}) {
        if (auto folder = find_data_file(name)) folders.push_back(std::move(*folder));
    }
    return folders;
}

std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    for (const fs::path& folder : shipped_folders()) {
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(folder, fault)) {
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
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
    for (const fs::path& folder : shipped_folders()) {
        if (fs::is_regular_file(folder / file, fault)) return (folder / file).string();
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
