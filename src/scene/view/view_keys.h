#pragma once

#include <vector>

#include "keys/keys.h"
#include "scene/view/view.h"

namespace fumon {

/// The keys of how a run is seen: camera, sun, air, look and image, bound to a view.
void list_view_keys(View& view, KeyTable& table);

/// Its parts: where the camera stands and its lens …
void list_camera_keys(CameraSettings& camera, KeyTable& table);
/// … the light, the air that it comes through …
void list_sun_keys(SunSettings& sun, KeyTable& table);
void list_air_keys(AirSettings& air, KeyTable& table);
/// … and colours, ground, heights and water.
void list_look_keys(LookSettings& look, KeyTable& table);
/// Those of what lies over the ground from files, [[layer]].
void list_layers(std::vector<LayerSettings>& layers, KeyTable& table);

}  // namespace fumon
