#include "run/run_identity.h"

#include <fmt/format.h>

#include "scene/input_maps.h"
#include "scene/overlay_keys.h"
#include "scene/scene_roles.h"
#include "scene/write.h"

namespace fumon {

Sha256 run_id(const Scene& scene, const InitialBed& initial) {
    Scene decisive = only_roles(scene, recorded_roles);
    decisive.output.columns = recorded_columns(scene);
    name_inputs(decisive, initial.inputs, &InputFile::hash);
    const WorldScale& scale = initial.scale;
    return text_hash(to_toml(decisive) + fmt::format("{} {} {} {}", scale.dx, scale.dy,
                                                     scale.height_unit, scale.in_metres));
}

}  // namespace fumon
