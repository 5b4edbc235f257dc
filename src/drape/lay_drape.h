#pragma once

#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// Reads the picture that look.drape names and lays it over the bed (scene.view.drape): by its own
/// georeference, brought to the bed's reference system, or over the bed's extent where the picture
/// or the bed says not where it lies, as initial.note then says. Its file stands after the others
/// of initial.inputs. Nothing where look.drape is empty. Throws InputError, located at the key,
/// where the file is missing, is no picture that can be read, is not among those of a picture's
/// metadata, is too large for a scene of unknown origin, or does not lie over the bed.
void lay_drape(Scene& scene, InitialBed& initial);

}  // namespace fumon
