#include "bmi/variables.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "files/udunits_unit.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

struct StandardName {
    std::string_view own;  ///< of a field or a key
    std::string_view standard;
};

constexpr std::array standard_names{
    StandardName{"water_depth", "land_surface_water__depth"},
    StandardName{"velocity_x", "land_surface_water_flow__x_component_of_velocity"},
    StandardName{"velocity_y", "land_surface_water_flow__y_component_of_velocity"},
    StandardName{"rock", "bedrock_surface__elevation"},
    StandardName{"sand", "land_surface_sand__thickness"},
    StandardName{"cover", "land_vegetation__area_fraction"},
    StandardName{"model.rain", "atmosphere_water__rainfall_volume_flux"},
};

std::string name_of(const std::string& own) {
    const auto* found = std::ranges::find(standard_names, own, &StandardName::own);
    return found == standard_names.end() ? own : std::string(found->standard);
}

}  // namespace

bool is_counted(std::string_view time_unit) {
    return time_unit != "s" && time_unit != "yr";
}

std::vector<Variable> variables_of(const Scene& scene, const Snapshot& first) {
    const bool bed_is_state = first.landform != Landform::air;
    const bool in_metres = first.scale.in_metres;
    const std::string height = in_metres ? "m" : "1";
    std::vector<Variable> variables;
    variables.push_back(
        {std::string(elevation_name), height, VariableKind::bed, "", bed_is_state, true});
    if (bed_is_state) {
        const std::string rate =
            is_counted(first.time_unit) ? height : height + "/" + first.time_unit;
        variables.push_back({std::string(uplift_name), udunits_unit(rate, in_metres),
                             VariableKind::uplift, "", true, false});
    }
    for (const SnapshotField& field : first.fields) {
        variables.push_back({name_of(field.name), udunits_unit(field.unit, in_metres),
                             VariableKind::field, field.name, false, true});
    }
    Scene copy = scene;
    const KeyTable table = scene_keys(copy);
    for (const Key& key : table.keys()) {
        const bool of_model = key.path.starts_with("model.") || key.path.starts_with("wind.");
        if (!of_model || !std::holds_alternative<double*>(key.target)) continue;
        variables.push_back({name_of(key.path), udunits_unit(key.notes.unit, in_metres),
                             VariableKind::parameter, key.path, true, false});
    }
    return variables;
}

}  // namespace fumon
