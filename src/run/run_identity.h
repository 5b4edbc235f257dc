#pragma once

#include "files/hash.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// Only what decides a run's results.
Scene without_looks(Scene scene);

/// What a run of this scene, made ready, is known by: every key that decides what it records, and
/// the content of its bed file, wherever that lies. How it looks does not matter.
Sha256 run_id(const Scene& scene, const InitialBed& initial);

}  // namespace fumon
