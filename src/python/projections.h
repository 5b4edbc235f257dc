#pragma once

#include <pybind11/pybind11.h>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon::python {

/// How a picture of a snapshot shows places, for Python to reckon with: a dict of the camera, the
/// block, the pixels of a map's bed, and where the bed lies. `first` is the snapshot by which
/// pictures are framed, `exaggeration` that of the picture. Throws InputError for the flat figure
/// of a section.
pybind11::dict projection_of(const Scene& scene, const Snapshot& first, const Snapshot& snapshot);

}  // namespace fumon::python
