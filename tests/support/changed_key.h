#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <variant>

#include "keys/keys.h"
#include "scene/scene_keys.h"

namespace fumon::test {

/// Gives a key another value of its type than it has.
inline void change_value(const Key& key) {
    struct Change {
        void operator()(bool* value) const { *value = !*value; }
        void operator()(std::int64_t* value) const { *value += 1; }
        void operator()(double* value) const { *value += 0.5; }
        void operator()(std::string* value) const { *value += "x"; }
        void operator()(const ChoiceTarget& target) const {
            const bool first = target.word() == target.words.front().word;
            ASSERT_TRUE(target.choose(target.words[first ? 1 : 0].word));
        }
        void operator()(const WordOrRealTarget& target) const {
            *target.value = {"", target.value->value + 0.5};
        }
        void operator()(const RealListTarget& target) const { target.values->push_back(0.5); }
        void operator()(const IntegerListTarget& target) const { target.values->push_back(1); }
        void operator()(const TextListTarget& target) const { target.values->emplace_back("x"); }
    };
    std::visit(Change{}, key.target);
}

/// A scene of a model with an item in each list of tables.
inline Scene scene_with_all_keys(const std::string& model) {
    Scene scene = default_scene(model);
    scene.view.overlays.resize(1);
    scene.figure.panels.resize(1);
    scene.figure.panels[0].curves.resize(1);
    scene.figure.panels[0].boxes.resize(1);
    return scene;
}

}  // namespace fumon::test
