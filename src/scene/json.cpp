#include "scene/json.h"

#include <nlohmann/json.hpp>
#include <string>

#include "scene/keys.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

struct ValueJson {
    Json operator()(const bool* value) const { return *value; }
    Json operator()(const std::int64_t* value) const { return *value; }
    Json operator()(const double* value) const { return *value; }
    Json operator()(const std::string* value) const { return *value; }
    Json operator()(const ChoiceTarget& target) const {
        return std::string(target.names[static_cast<std::size_t>(target.get())].name);
    }
    Json operator()(const WordOrRealTarget& target) const {
        return target.value->is_word() ? Json(target.value->word) : Json(target.value->value);
    }
    Json operator()(const RealListTarget& target) const { return *target.values; }
    Json operator()(const IntegerListTarget& target) const { return *target.values; }
    Json operator()(const TextListTarget& target) const { return *target.values; }
};

}  // namespace

Json scene_json(const Scene& scene) {
    Scene copy = scene;  // the table binds to writable values
    Json json;
    const KeyTable table = scene_keys(copy);
    for (const Key& key : table.keys()) {
        const std::size_t dot = key.path.find('.');
        Json value = std::visit(ValueJson{}, key.target);
        if (dot == std::string::npos) {
            json[key.path] = std::move(value);
        } else {
            json[key.path.substr(0, dot)][key.path.substr(dot + 1)] = std::move(value);
        }
    }
    return json;
}

}  // namespace fumon
