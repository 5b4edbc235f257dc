#include "run/run_identity.h"

#include <fmt/format.h>

#include "scene/write.h"

namespace fumon {

Scene without_looks(Scene scene) {
    const OutputSettings output = scene.output;
    scene.sweep = {};
    scene.figure = {};
    scene.view = {};
    scene.output = {};
    scene.output.measure_every = output.measure_every;
    scene.output.fields_every = output.fields_every;
    scene.output.fields_at = output.fields_at;
    scene.output.avalanches = output.avalanches;
    return scene;
}

Sha256 run_id(const Scene& scene, const InitialBed& initial) {
    Scene decisive = without_looks(scene);
    if (!initial.inputs.empty()) decisive.bed.file = initial.inputs.front().hash;
    const WorldScale& scale = initial.scale;
    return text_hash(to_toml(decisive) + fmt::format("{} {} {} {}", scale.dx, scale.dy,
                                                     scale.height_unit, scale.in_metres));
}

}  // namespace fumon
