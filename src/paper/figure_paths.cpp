#include "paper/figure_paths.h"

#include <algorithm>
#include <iterator>

namespace fumon {

namespace {

namespace fs = std::filesystem;

using Names = std::map<std::string, std::string, std::greater<>>;

std::string replaced(std::string_view text, const Names& names) {
    std::string made;
    while (!text.empty()) {
        const auto known = text.front() != '/'
                               ? names.end()
                               : std::ranges::find_if(names, [text](const auto& name) {
                                     return text.starts_with(name.first);
                                 });
        if (known == names.end()) {
            made += text.front();
            text.remove_prefix(1);
        } else {
            made += known->second;
            text.remove_prefix(known->first.size());
        }
    }
    return made;
}

/// Whether two files are of one tree: in one folder, or in folders not far apart below a folder
/// that is neither the root nor right below it, as homes of users are.
bool are_of_one_tree(const fs::path& file, const fs::path& folder) {
    constexpr auto most = 2;   // folders up from the one
    constexpr auto least = 3;  // parts of the path of the folder that both are in: /home/name
    const auto up = std::ranges::count(file.lexically_relative(folder), fs::path(".."));
    return up == 0 || (up <= most && std::distance(folder.begin(), folder.end()) - up >= least);
}

/// A path as seen from a folder; both relative, and perhaps leading upwards.
std::string path_from(const fs::path& folder, const std::string& path) {
    const fs::path deep("/1/2/3/4/5/6/7/8");
    return (deep / path)
        .lexically_normal()
        .lexically_relative((deep / folder).lexically_normal())
        .string();
}

}  // namespace

FigurePaths::FigurePaths(const FigurePlan& plan, const FigureSources& sources)
    : folder_(fs::path(plan.file).parent_path()) {
    const auto add = [this](const std::string& path) {
        if (fs::path(path).is_absolute()) names_[path] = name_of(path);
    };
    add(plan.file);
    for (const SourceText& source : sources.all()) add(source.path);
    for (const InputFile& input : plan.inputs) add(input.path);
}

std::string FigurePaths::name_of(const std::string& path) const {
    const fs::path file(path);
    if (!file.is_absolute()) return path;
    if (!folder_.is_absolute() || !are_of_one_tree(file, folder_)) return file.filename().string();
    return file.lexically_relative(folder_).string();
}

std::string FigurePaths::in_text(std::string_view text) const {
    return replaced(text, names_);
}

std::string FigurePaths::in_source(const SourceText& source) const {
    const fs::path folder = fs::path(name_of(source.path)).parent_path();
    Names near;
    for (const auto& [path, name] : names_) near[path] = path_from(folder, name);
    return replaced(source.text, near);
}

}  // namespace fumon
