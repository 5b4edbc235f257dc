#pragma once

#include "film/script/film.h"
#include "scene/faults.h"

namespace fumon {

/// Checks the keys of a film against each other, without a run; adds what breaks the rules to
/// `faults`, located at the key to change.
void check_film(const Film& film, Faults& faults);

/// Adds the faults of what a film cuts from others, once these are read.
void check_excerpts(const Film& film, Faults& faults);

}  // namespace fumon
