#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "fuzz_input.h"
#include "models/registry.h"
#include "scene/initial_bed.h"
#include "scene/json.h"
#include "scene/read.h"
#include "scene/schedule.h"
#include "scene/write.h"

namespace fumon::fuzz {

/// Reads a scene as `fumon check` does, on a grid small enough to build. A scene that is taken must
/// read the same from its resolved text, and have a manifest.
inline void read_and_build(const std::string& text, const std::vector<std::string>& settings) {
    const bool fine = taken([&] {
        const Scene scene = parse_scene(text, "scene.toml", "", settings);
        const std::string resolved = to_toml(scene);
        if (to_toml(parse_scene(resolved, "resolved.toml", "")) != resolved)
            broken_promise("a resolved scene reads back the same", resolved);
        if (scene_json(scene).dump().empty()) broken_promise("a scene has a manifest", resolved);
        if (frame_schedule(scene).count() < 0) broken_promise("frames can be counted", resolved);
        constexpr std::int64_t most_cells = 1024;
        if (bed_kind(scene) == BedKind::file || scene.grid.nx > most_cells ||
            scene.grid.ny > most_cells || scene.grid.nx * scene.grid.ny > most_cells)
            return;
        const InitialBed initial = make_initial_bed(scene);
        static WorkerPool pool(1, "fuzz");
        const auto model = find_model(scene.model.name)
                               ->make(scene.model.parameters,
                                      {initial.bed, initial.nodata, initial.scale,
                                       static_cast<std::uint64_t>(scene.seed), pool, false});
        if (model->snapshot().bed.size() == 0) broken_promise("a model has a bed", resolved);
    });
    static_cast<void>(fine);
}

}  // namespace fumon::fuzz
