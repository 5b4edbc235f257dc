#pragma once

#include "render/light/light.h"
#include "scene/scene.h"

namespace fumon {

/// The light of a view, whose ground is chosen: of its sky.
Light light_of_view(const View& view);

/// The view, whose ground is chosen, with look.light chosen: the sun's or a studio's, in which
/// the lamp stands in the sun's place and is so wide that sun.diameter is its own.
View with_chosen_light(View view);

/// The air that a view is seen through, whose ground is chosen: thin or desert.
Aerosol chosen_aerosol(const View& view);

/// The height of the clouds' base above the ground, km.
double cloud_kilometres(const AirSettings& air);

}  // namespace fumon
