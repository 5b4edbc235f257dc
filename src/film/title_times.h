#pragma once

#include "film/script/film.h"
#include "scene/faults.h"

namespace fumon {

/// Notes captions that are shown at the same time, captions that end after the film, and cards over
/// the picture that last longer than the shots or that stand over one another, as faults of their
/// keys. The film's shots and excerpts have been checked before.
void check_title_times(const Film& film, Faults& faults);

}  // namespace fumon
