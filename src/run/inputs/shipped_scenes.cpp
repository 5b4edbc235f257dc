#include "run/inputs/shipped_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <system_error>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "files/input_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

std::string title_of(const fs::path& file) {
    std::istringstream text(read_input_file(file));
    std::string comment;
    bool in_head = true;
    for (std::string line; std::getline(text, line);) {
        constexpr std::string_view title = "title = \"";
        if (line.starts_with(title) && line.ends_with('"'))
            return line.substr(title.size(), line.size() - title.size() - 1);
        if (line.starts_with("[")) break;  // titles of panels and cards come later
        in_head = in_head && line.starts_with("#");
        if (in_head) comment += line.substr(1);
    }
    const std::size_t end = std::min(comment.find_first_of(".:"), comment.size());
    return comment.empty() ? "" : comment.substr(1, end - 1);
}

bool has_word(const std::string& name, const std::string& word) {
    const std::string stem = "-" + fs::path(name).filename().string() + "-";
    return stem.find("-" + word + "-") != std::string::npos;
}

}  // namespace

std::vector<ShippedScene> shipped_scenes(const std::vector<std::string>& folders) {
    std::vector<ShippedScene> all;
    for (const std::string& folder : folders) {
        const auto place = find_data_file(folder.empty() ? "scenes" : "scenes/" + folder);
        if (!place) continue;
        std::vector<fs::path> files;
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(*place, fault)) {
            if (entry.path().extension() == ".toml") files.push_back(entry.path());
        }
        std::ranges::sort(files);
        for (const fs::path& file : files)
            all.push_back({(fs::path(folder) / file.stem()).string(), file, title_of(file)});
    }
    return all;
}

std::vector<ShippedScene> matching_scenes(const std::string& word) {
    const std::vector<ShippedScene> all = shipped_scenes(shipped_folders);
    std::string name = word;
    if (name.ends_with(".toml")) name.resize(name.size() - std::string_view(".toml").size());
    std::vector<ShippedScene> meant;
    const auto take = [&](const auto& is_meant) {
        if (meant.empty()) std::ranges::copy_if(all, std::back_inserter(meant), is_meant);
    };
    take([&](const ShippedScene& scene) { return scene.name == name; });
    take([&](const ShippedScene& scene) { return has_word(scene.name, name); });
    take([&](const ShippedScene& scene) { return scene.file.stem() == name; });
    if (!meant.empty()) return meant;
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const ShippedScene& scene : all) names.push_back(scene.name);
    const std::string nearest = nearest_name(name, names);
    throw InputError(fmt::format("fumon new: fumon ships no scene \"{}\"; {}", word,
                                 nearest.empty() ? "`fumon scenes` lists them"
                                                 : fmt::format("did you mean \"{}\"?", nearest)));
}

std::string relocatable_text(const ShippedScene& scene) {
    std::istringstream text(read_input_file(scene.file));
    std::string moved;
    for (std::string line; std::getline(text, line);) {
        for (std::size_t begin = 0; !line.starts_with("#");) {
            begin = line.find('"', begin);
            const std::size_t end = begin == std::string::npos ? begin : line.find('"', begin + 1);
            if (end == std::string::npos) break;
            const fs::path named = line.substr(begin + 1, end - begin - 1);
            std::error_code fault;
            const fs::path there = scene.file.parent_path() / named;
            std::string whole = named.string();
            if (named.is_relative() && named.has_extension() && fs::is_regular_file(there, fault))
                whole = fs::canonical(there, fault).string();
            line.replace(begin + 1, end - begin - 1, whole);
            begin += whole.size() + 2;
        }
        moved += line + "\n";
    }
    return moved;
}

}  // namespace fumon
