#pragma once

#include <array>

#include "files/hash.h"
#include "keys/key_role.h"
#include "scene/initial_bed.h"
#include "scene/scene.h"

namespace fumon {

/// The roles of the keys on which a run's numbers depend: what it computes, and when it measures.
inline constexpr std::array measured_roles{KeyRole::run, KeyRole::parameter, KeyRole::sampling};

/// The roles of the keys on which what a run records depends, whatever its pictures.
inline constexpr std::array recorded_roles{KeyRole::run, KeyRole::parameter, KeyRole::sampling,
                                           KeyRole::label, KeyRole::record};

/// Identifies the run of a prepared scene: hashes every key that decides what it records, and the
/// content of its bed file, wherever that lies. How it looks does not matter.
Sha256 run_id(const Scene& scene, const InitialBed& initial);

}  // namespace fumon
