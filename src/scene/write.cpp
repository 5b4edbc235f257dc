#include "scene/write.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "keys/key_value.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// "[camera]", or "[[overlay]]" for an item of a list of tables ("overlay.0").
std::string header(const std::string& owner) {
    const bool item = owner.find_last_not_of("0123456789") == owner.rfind('.');
    const std::string name = without_numbers(owner);
    return item ? fmt::format("\n[[{}]]\n", name) : fmt::format("\n[{}]\n", name);
}

}  // namespace

std::string to_toml(const Scene& scene) {
    Scene copy = scene;  // the table binds to writable values
    return to_toml(scene_keys(copy));
}

std::string to_toml(const KeyTable& table, std::string_view left_out) {
    std::vector<std::string> sections;
    std::unordered_map<std::string, std::size_t> places;
    for (const Key& key : table.keys()) {
        if (key.path == left_out) continue;
        const std::size_t dot = key.path.rfind('.');
        const std::string owner = dot == std::string::npos ? "" : key.path.substr(0, dot);
        const auto [place, fresh] = places.emplace(owner, sections.size());
        if (fresh) sections.push_back(owner.empty() ? "" : header(owner));
        sections[place->second] +=
            fmt::format("{} = {}\n", key.path.substr(dot + 1), value_text(key));
    }
    return fmt::format("{}", fmt::join(sections, ""));
}

}  // namespace fumon
