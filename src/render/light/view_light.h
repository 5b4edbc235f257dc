#pragma once

#include "render/light/light.h"
#include "scene/scene.h"

namespace fumon {

/// The light of a view, whose ground is chosen: of its sky.
Light light_of_view(const View& view);

/// The air that a view is seen through, whose ground is chosen: thin or desert.
Aerosol chosen_aerosol(const View& view);

/// The height of the clouds' base above the ground, km.
double cloud_kilometres(const AirSettings& air);

}  // namespace fumon
