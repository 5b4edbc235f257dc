#pragma once

#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// Reads the files that [[layer]] names and lays their lines, points and areas over the bed
/// (scene.view.placed_layers), after lay_drape(): brought to the bed's reference system; where it
/// or the file names none, coordinates are taken for the bed's, as initial.note then says. The
/// files stand after the others of initial.inputs. Nothing where there are no layers. Throws
/// InputError, located at the key, where a file is missing, cannot be read, is not among those of a
/// picture's metadata, has no such layer or field, holds a geometry collection, or lies beside the
/// bed.
void lay_layers(Scene& scene, InitialBed& initial);

}  // namespace fumon
