#include "scene/view/palette_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

std::vector<std::string> palette_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_file("assets/palettes"))) {
        if (entry.path().extension() == ".txt") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

void check_palette_name(std::string_view name) {
    const std::vector<std::string> names = palette_names();
    if (std::ranges::find(names, name) != names.end()) return;
    throw InputError(fmt::format("unknown palette \"{}\"; {}", name, suggestion(name, names)));
}

}  // namespace fumon
