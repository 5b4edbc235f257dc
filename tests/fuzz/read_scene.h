#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fuzz_input.h"
#include "scene/read.h"

namespace fumon::fuzz {

/// Reads a scene; none where it is refused.
inline std::optional<Scene> read_scene_text(const std::string& text,
                                            const std::vector<std::string>& settings = {}) {
    std::optional<Scene> scene;
    taken([&] { scene = parse_scene(text, "scene.toml", "", settings); }, RefusalLines::many);
    return scene;
}

}  // namespace fumon::fuzz
