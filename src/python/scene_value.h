#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "scene/read.h"

namespace fumon::python {

/// A key, and its value as TOML.
using Setting = std::pair<std::string, std::string>;

/// A scene as its text and what Python has set, in order; changed as a whole or not at all.
class SceneValue {
  public:
    /// Throws InputError as parse_scene().
    SceneValue(SceneText text, const std::vector<Setting>& settings);

    /// Throws InputError, with nothing changed, as parse_scene().
    void set(const std::vector<Setting>& settings);

    /// The value of a key. Throws pybind11::key_error, naming the nearest key.
    [[nodiscard]] pybind11::object get(const std::string& path) const;
    /// All keys, in the order of `fumon describe`.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// The first step after this one of which the scene takes a frame; −1: none.
    [[nodiscard]] std::int64_t next_frame(std::int64_t after) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const SceneText& text() const { return text_; }
    [[nodiscard]] const std::vector<Override>& overrides() const { return overrides_; }

  private:
    SceneText text_;
    std::vector<Override> overrides_;
    Scene scene_;
};

}  // namespace fumon::python
