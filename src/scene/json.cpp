#include "scene/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "keys/keys.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

struct ValueJson {
    Json operator()(const bool* value) const { return *value; }
    Json operator()(const std::int64_t* value) const { return *value; }
    Json operator()(const double* value) const { return *value; }
    Json operator()(const std::string* value) const { return *value; }
    Json operator()(const ChoiceTarget& target) const { return std::string(target.word()); }
    Json operator()(const WordOrRealTarget& target) const {
        return target.value->is_word() ? Json(target.value->word) : Json(target.value->value);
    }
    Json operator()(const RealListTarget& target) const { return *target.values; }
    Json operator()(const IntegerListTarget& target) const { return *target.values; }
    Json operator()(const TextListTarget& target) const { return *target.values; }
};

/// Where the value of a path stands; numbers in it count the items of lists.
Json& place(Json& json, const std::string& path) {
    Json* at = &json;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        const std::string name = path.substr(start, end - start);
        const bool number = name.find_first_not_of("0123456789") == std::string::npos;
        at = number ? &(*at)[std::stoul(name)] : &(*at)[name];
        start = end + 1;
    }
    return *at;
}

/// Whether a key names a file, whose content counts and not where it lies.
bool names_input(const std::string& path) {
    return path == "bed.file" || (path.starts_with("map.") && path.ends_with(".file"));
}

std::string difference_below(const Json& previous, const Json& now, const std::string& prefix) {
    for (const auto& [name, value] : previous.items()) {
        const std::string path = prefix + name;
        if (!now.contains(name)) return fmt::format("its scene has {}, now it has none", path);
        if (value.is_object()) {
            std::string inside = difference_below(value, now[name], path + ".");
            if (!inside.empty()) return inside;
        } else if (value.is_array() && now[name].is_array() && value.size() == now[name].size() &&
                   !value.empty() && value.front().is_object()) {
            for (std::size_t n = 0; n < value.size(); ++n) {
                std::string inside =
                    difference_below(value[n], now[name][n], fmt::format("{}.{}.", path, n));
                if (!inside.empty()) return inside;
            }
        } else if (value != now[name] && !names_input(path)) {
            return fmt::format("its scene has {} = {}, now {}", path, json_text(value),
                               json_text(now[name]));
        }
    }
    for (const auto& [name, value] : now.items()) {
        if (!previous.contains(name))
            return fmt::format("its scene has no {}{}, now it has one", prefix, name);
    }
    return {};
}

}  // namespace

std::string json_text(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json scene_json(const Scene& scene) {
    std::vector<KeyRole> all;
    for (const KeyRoleText& role : key_roles()) all.push_back(role.role);
    return scene_json(scene, all);
}

Json scene_json(const Scene& scene, std::span<const KeyRole> roles) {
    Scene copy = scene;  // the table binds to writable values
    Json json;
    const KeyTable table = scene_keys(copy);
    for (const Key& key : table.keys()) {
        if (std::find(roles.begin(), roles.end(), key.role) != roles.end())
            place(json, key.path) = std::visit(ValueJson{}, key.target);
    }
    return json;
}

std::string scene_difference(const Json& previous, const Json& now) {
    return difference_below(previous, now, "");
}

}  // namespace fumon
