#pragma once

#include "render/life/body_shapes.h"
#include "render/life/person_figure.h"

namespace fumon {

/// A person on both feet: metres, from the ground between the heels; looking along +y, x to the
/// right. The same each time.
BodyMesh person_mesh(const PersonFigure& figure);

}  // namespace fumon
