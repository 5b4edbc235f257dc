#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// Names the keys that the parameter lines over the frames show where the scene does not: those of
/// the model that are written, or its name where none is. Done before anything is made of the
/// scene, so that the resolved scene names them too. Throws InputError, located, for a key that
/// there is not.
void name_parameter_keys(Scene& scene);

/// Whether something is drawn over a scene's frames: overlays that are shown, or contours.
bool has_overlays(const Scene& scene);

/// The columns of the measurements that the plots over a scene's frames show; none without plots.
std::vector<std::string> plotted_columns(const Scene& scene);

/// The columns, and groups of columns, that a scene's measurements have: those of output.columns
/// and those that plots show. None: all.
std::vector<std::string> recorded_columns(const Scene& scene);

}  // namespace fumon
