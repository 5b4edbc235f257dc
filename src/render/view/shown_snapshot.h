#pragma once

#include <optional>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// The same snapshot, through which all that is drawn comes: throws Error with the place of a
/// number beyond those for which pictures are made (base/limits.h).
const Snapshot& drawable(const Snapshot& snapshot);

/// A snapshot as it is drawn, where that is not the snapshot itself:
///
/// - a profile (a single row) becomes a strip: look.profile_sites of its sites from
///   look.profile_start on, a quarter as deep as long and the same all across; where its air is
///   shown too (look.air, scenic), all of its sites, a third as deep as long. A strip has a section
///   only then;
/// - a bed of far more cells than the picture has pixels becomes one of fewer, each the mean of
///   k × k: where the whole block is in the picture (camera.distance = "fit"), as many as leave at
///   least one cell a pixel along the longer sides of both, and 1024 cells; else, where it has more
///   than 8192 cells on a side, no more than these;
/// - a coast has the water of look.sea_level, see add_sea().
///
/// Nothing when the snapshot is drawn as it is.
std::optional<Snapshot> shown_snapshot(const Snapshot& snapshot, const View& view);

/// Whether a pile is drawn as dry sand poured on a board (look.pile): not where colours tell
/// heights or slopes.
bool draws_poured_sand(const Snapshot& snapshot, const LookSettings& look);

}  // namespace fumon
