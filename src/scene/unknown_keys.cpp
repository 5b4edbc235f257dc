#include "scene/unknown_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <any>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "models/registry.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// The item of a list to which a key belongs, as "figure.panel.0."; empty for none.
std::string_view item_of(std::string_view path) {
    for (std::size_t end = path.rfind('.'); end != path.npos && end > 0;) {
        const std::size_t dot = path.rfind('.', end - 1);
        const std::string_view part = path.substr(dot + 1, end - dot - 1);
        if (part.find_first_not_of("0123456789") == part.npos) return path.substr(0, end + 1);
        end = dot;
    }
    return {};
}

/// Refuses a key of a list's item that is not there.
void refuse_missing_item(const std::string& path, const std::string& place, const KeyTable& table) {
    for (const TableList& list : table.lists()) {
        if (!path.starts_with(list.path + ".")) continue;
        std::size_t item = 0;
        const char* end = path.data() + path.size();
        const auto [stop, fault] = std::from_chars(path.data() + list.path.size() + 1, end, item);
        if (fault != std::errc{} || stop == end || *stop != '.' || item < list.size()) continue;
        throw InputError(fmt::format(
            "{}: there is no {}.{}: the scene has {} [[{}]], and they are counted from 0", place,
            list.path, item, list.size() == 0 ? "no" : fmt::format("{}", list.size()),
            without_numbers(list.path)));
    }
}

/// What to ask `fumon describe` for: a key's own section where every scene has it.
std::string what_describes(const std::string& path, const std::string& model) {
    const std::string begin = path.substr(0, path.find('.') + 1);
    Scene any;
    const KeyTable common = scene_keys(any);
    const bool of_all = begin.ends_with('.') && begin != "model." &&
                        std::ranges::any_of(common.keys(), [&](const Key& key) {
                            return key.path.starts_with(begin);
                        });
    if (of_all) return begin.substr(0, begin.size() - 1);
    return model.empty() ? "scene" : model;
}

std::string other_model_with(const std::string& path) {
    for (const ModelEntry& entry : models()) {
        std::any parameters = entry.default_parameters();
        KeyTable table;
        entry.list_keys(parameters, table);
        if (table.find(path) != nullptr) return std::string(entry.name);
    }
    return {};
}

}  // namespace

bool is_section(const KeyTable& table, const std::string& path) {
    const std::string begin = path + ".";
    return std::ranges::any_of(table.keys(),
                               [&](const Key& key) { return key.path.starts_with(begin); });
}

void refuse_unknown_key(const std::string& path, const std::string& place, const KeyTable& table,
                        const std::string& model) {
    if (table.find_list(path) != nullptr) {
        throw InputError(fmt::format(
            "{}: {} is a list of sections; write [[{}]] and its keys below, once for each", place,
            path, without_numbers(path)));
    }
    if (is_section(table, path)) {
        throw InputError(
            fmt::format("{}: {} is a section; write [{}] and its keys below", place, path, path));
    }
    refuse_missing_item(path, place, table);
    std::vector<std::string> known;
    for (const Key& key : table.keys()) {
        if (path.starts_with(item_of(key.path))) known.push_back(key.path);
    }
    if (const std::string owner = other_model_with(path); !owner.empty()) {
        throw InputError(fmt::format(
            "{}: {} belongs to the model \"{}\", not to \"{}\"; see `fumon describe {}`", place,
            path, owner, model, model));
    }
    std::string nearest = nearest_name(path, known);
    const std::string last = path.substr(path.rfind('.') + 1);
    for (const std::string& candidate : known) {  // the right name in the wrong section
        if (nearest.empty() && candidate.substr(candidate.rfind('.') + 1) == last)
            nearest = candidate;
    }
    if (!nearest.empty()) {
        throw KeyError(
            nearest, fmt::format("{}: unknown key {}; did you mean \"{}\"?", place, path, nearest));
    }
    throw InputError(fmt::format("{}: unknown key {}; `fumon describe {}` lists the known ones",
                                 place, path, what_describes(path, model)));
}

}  // namespace fumon
