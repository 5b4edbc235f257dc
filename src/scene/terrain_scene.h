#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// A terrain file alone as a scene: the static model with the standard look. `heights` is
/// "low:high", the metres of black and white of a PNG terrain, or empty. Throws InputError.
Scene terrain_scene(const std::string& file, const std::string& heights,
                    const std::vector<std::string>& settings);

/// Whether a file to run is terrain and no scene: it has an ending, which is neither .toml nor that
/// of what fumon draws. A .png is where the settings say bed.heights.
bool is_terrain_name(const std::string& file, const std::vector<std::string>& settings = {});

/// A terrain file alone as a run. With settings model.…, water.…, edge.… or gauge.… that do not
/// name another model: an hour of water over it (model "water", or "gully") in steps of ten
/// seconds, with Manning's friction of bare ground and a frame every 40 seconds, and its fields
/// every ten minutes; settings frames.… choose frames instead. Else the terrain as it is, in one
/// frame. What the settings say goes before all that. Throws InputError.
Scene terrain_run(const std::string& file, const std::vector<std::string>& settings);

}  // namespace fumon
