#include "base/data_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/platform.h"

namespace fumon {

namespace {

std::vector<std::filesystem::path>& added_folders() {
    static std::vector<std::filesystem::path> folders;
    return folders;
}

/// A folder below the one that the program was installed to.
std::optional<std::filesystem::path> beside_program(const char* folder) {
    const std::filesystem::path program = platform::program_file();
    if (program.empty()) return std::nullopt;
    return program.parent_path().parent_path() / folder;
}

std::optional<std::filesystem::path> found_in(const std::vector<std::filesystem::path>& roots,
                                              std::string_view relative) {
    for (const auto& root : roots) {
        auto candidate = root / relative;
        std::error_code ignored;
        if (std::filesystem::exists(candidate, ignored)) return candidate;
    }
    return std::nullopt;
}

std::vector<std::filesystem::path> data_roots() {
    std::vector<std::filesystem::path> roots;
    if (const char* chosen = std::getenv("FUMON_DATA_DIR"); chosen != nullptr && *chosen != '\0') {
        roots.emplace_back(chosen);
    }
    roots.insert(roots.end(), added_folders().begin(), added_folders().end());
    if (const auto shared = beside_program(FUMON_SHARE_FOLDER)) roots.push_back(*shared);
    roots.emplace_back(FUMON_SOURCE_FOLDER);
    return roots;
}

}  // namespace

void add_data_folder(std::filesystem::path folder) {
    added_folders().push_back(std::move(folder));
}

void add_data_of_library(const std::filesystem::path& library) {
    std::error_code ignored;
    for (std::filesystem::path above = library.parent_path(); !above.empty();
         above = above.parent_path()) {
        std::filesystem::path folder = above / FUMON_SHARE_FOLDER;
        if (std::filesystem::is_directory(folder / "shaders", ignored))
            return add_data_folder(std::move(folder));
        if (above == above.root_path()) return;
    }
}

std::optional<std::filesystem::path> find_data_file(std::string_view relative) {
    return found_in(data_roots(), relative);
}

std::optional<std::filesystem::path> find_document(std::string_view relative) {
    std::vector<std::filesystem::path> roots;
    if (const auto documents = beside_program(FUMON_DOCUMENT_FOLDER)) roots.push_back(*documents);
    roots.emplace_back(FUMON_SOURCE_FOLDER);
    return found_in(roots, relative);
}

std::filesystem::path data_file(std::string_view relative) {
    if (auto found = find_data_file(relative)) return std::move(*found);
    std::vector<std::string> tried;
    for (const auto& root : data_roots()) tried.push_back((root / relative).string());
    throw Error(fmt::format("{} is missing (looked for {}); reinstall fumon or set FUMON_DATA_DIR",
                            relative, fmt::join(tried, ", ")));
}

}  // namespace fumon
