#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// What a variable of the Basic Model Interface means here.
enum class VariableKind {
    bed,        ///< the height of the ground
    uplift,     ///< at what rate the ground is raised from outside
    field,      ///< a field of the snapshot
    parameter,  ///< a number of the scene: one for the whole grid
};

struct Variable {
    std::string name;  ///< CSDMS standard name, where there is one; else fumon's
    std::string unit;  ///< as UDUNITS; "1" for a pure number
    VariableKind kind;
    std::string source;  ///< the field's or the key's name
    bool input;          ///< may be set
    bool output;         ///< shows what the model computes

    [[nodiscard]] bool on_grid() const { return kind != VariableKind::parameter; }
};

inline constexpr std::string_view elevation_name = "land_surface__elevation";
inline constexpr std::string_view uplift_name = "bedrock__uplift_rate";

/// Whether a model's unit of time is a count (steps, grains), which UDUNITS calls "1".
bool is_counted(std::string_view time_unit);

/// The variables of a scene's model: the bed, its uplift (of models whose bed can be set), all
/// fields of its snapshots, and every real number of [model] and [wind].
std::vector<Variable> variables_of(const Scene& scene, const Snapshot& first);

}  // namespace fumon
