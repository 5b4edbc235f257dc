// Scenes that are taken: resolved texts, manifests and schedules.

#include <nlohmann/json.hpp>

#include "read_scene.h"
#include "scene/json.h"
#include "scene/schedule.h"
#include "scene/write.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const auto scene = fuzz::read_scene_text(std::string(fuzz::as_text(data, size)));
    if (!scene) return -1;
    const std::string resolved = to_toml(*scene);
    if (to_toml(parse_scene(resolved, "resolved.toml", "")) != resolved)
        fuzz::broken_promise("a resolved scene reads back the same", resolved);
    if (scene_json(*scene).dump().empty()) fuzz::broken_promise("a scene has a manifest", resolved);
    for (const Schedule& schedule : {frame_schedule(*scene), bed_schedule(*scene),
                                     fields_schedule(*scene), measurement_schedule(*scene)}) {
        if (schedule.count() < 0 || schedule.due(-1))
            fuzz::broken_promise("steps can be counted", resolved);
    }
    return 0;
}
