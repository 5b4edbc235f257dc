#include <pybind11/stl.h>

#include <variant>

#include "base/nearest_name.h"
#include "models/registry.h"
#include "python/module.h"
#include "python/scene_value.h"
#include "run/inputs/scene_argument.h"
#include "scene/scene_keys.h"
#include "scene/schedule.h"
#include "scene/write.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

/// A key's value as Python has such values.
struct AsPython {
    py::object operator()(const bool* value) const { return py::cast(*value); }
    py::object operator()(const std::int64_t* value) const { return py::cast(*value); }
    py::object operator()(const double* value) const { return py::cast(*value); }
    py::object operator()(const std::string* value) const { return py::cast(*value); }
    py::object operator()(const ChoiceTarget& target) const {
        return py::cast(std::string(target.word()));
    }
    py::object operator()(const WordOrRealTarget& target) const {
        return target.value->is_word() ? py::cast(target.value->word)
                                       : py::cast(target.value->value);
    }
    py::object operator()(const RealListTarget& target) const { return py::cast(*target.values); }
    py::object operator()(const IntegerListTarget& target) const {
        return py::cast(*target.values);
    }
    py::object operator()(const TextListTarget& target) const { return py::cast(*target.values); }
};

std::vector<Override> overrides_of(const std::vector<Setting>& settings) {
    std::vector<Override> overrides;
    overrides.reserve(settings.size());
    for (const auto& [path, value] : settings) overrides.push_back({path, value, python_place});
    return overrides;
}

/// A bare model, which lasts no step: what a bed that Python brings is drawn as.
SceneText terrain_text() {
    return {"[model]\nname = \"" + std::string(terrain_model().name) + "\"\n", "", ""};
}

}  // namespace

SceneValue::SceneValue(SceneText text, const std::vector<Setting>& settings)
    : text_(std::move(text)),
      overrides_(overrides_of(settings)),
      scene_(parse_scene(text_, overrides_)) {}

void SceneValue::set(const std::vector<Setting>& settings) {
    std::vector<Override> all = overrides_;
    for (const Override& one : overrides_of(settings)) {
        std::erase_if(all, [&](const Override& other) { return other.path == one.path; });
        all.push_back(one);
    }
    scene_ = parse_scene(text_, all);
    overrides_ = std::move(all);
}

py::object SceneValue::get(const std::string& path) const {
    Scene copy = scene_;
    const KeyTable table = scene_keys(copy);
    if (const Key* key = table.find(path)) return std::visit(AsPython{}, key->target);
    const std::string nearest = nearest_name(path, keys());
    throw py::key_error(path + (nearest.empty() ? " is not a key of this scene"
                                                : "; did you mean \"" + nearest + "\"?"));
}

std::vector<std::string> SceneValue::keys() const {
    Scene copy = scene_;
    const KeyTable table = scene_keys(copy);
    std::vector<std::string> paths;
    for (const Key& key : table.keys()) paths.push_back(key.path);
    return paths;
}

std::int64_t SceneValue::next_frame(std::int64_t after) const {
    const Schedule schedule = frame_schedule(scene_);
    for (std::int64_t step = after + 1; step <= scene_.run.steps; ++step) {
        if (schedule.due(step)) return step;
    }
    return -1;
}

void define_scenes(py::module_& core) {
    py::class_<SceneValue>(core, "SceneValue")
        .def_static(
            "read",
            [](const std::string& name, const std::vector<Setting>& settings) {
                return SceneValue(read_scene_text(scene_argument(name)), settings);
            },
            py::arg("name"), py::arg("settings"))
        .def_static(
            "parse",
            [](std::string text, std::string source, const std::string& directory,
               const std::vector<Setting>& settings) {
                return SceneValue({std::move(text), std::move(source), directory}, settings);
            },
            py::arg("text"), py::arg("source"), py::arg("directory"), py::arg("settings"))
        .def_static(
            "terrain",
            [](const std::vector<Setting>& settings) {
                return SceneValue(terrain_text(), settings);
            },
            py::arg("settings"))
        .def("set", &SceneValue::set, py::arg("settings"))
        .def("get", &SceneValue::get, py::arg("path"))
        .def("keys", &SceneValue::keys)
        .def("next_frame", &SceneValue::next_frame, py::arg("after"))
        .def("toml", [](const SceneValue& value) { return to_toml(value.scene()); })
        .def_property_readonly("source",
                               [](const SceneValue& value) { return value.text().source; })
        .def("parts",
             [](const SceneValue& value) {
                 std::vector<Setting> settings;
                 settings.reserve(value.overrides().size());
                 for (const Override& one : value.overrides())
                     settings.emplace_back(one.path, one.value);
                 const SceneText& text = value.text();
                 return py::make_tuple(text.text, text.source, text.directory.string(), settings);
             })
        .def("copy", [](const SceneValue& value) { return SceneValue(value); });
}

}  // namespace fumon::python
