#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz_input.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon::fuzz {

/// Reads a scene; none where it is refused.
inline std::optional<Scene> read_scene_text(const std::string& text,
                                            const std::vector<std::string>& settings = {}) {
    std::optional<Scene> scene;
    taken([&] { scene = parse_scene(text, "scene.toml", "", settings); }, RefusalLines::many);
    return scene;
}

/// Reads a scene without a terrain file and of few cells; none where it is another.
inline std::optional<Scene> read_small_scene(const std::string& text) {
    constexpr std::int64_t most_cells = 1024;
    std::optional<Scene> scene = read_scene_text(text);
    if (!scene || bed_kind(*scene) == BedKind::file || scene->grid.nx > most_cells ||
        scene->grid.ny > most_cells || scene->grid.nx * scene->grid.ny > most_cells)
        return std::nullopt;
    return scene;
}

inline std::optional<Scene> read_small_scene(const std::uint8_t* data, std::size_t size) {
    return read_small_scene(std::string(as_text(data, size)));
}

}  // namespace fumon::fuzz
