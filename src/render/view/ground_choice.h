#pragma once

#include <optional>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// Why the bed of a run that starts with `first` cannot go on to the horizon in this view: "is for
/// scenic views (look.mode)"; null where it can.
const char* endless_ground_obstacle(const View& view, const Snapshot& first);

/// Whether it goes on: where look.ground says so, and where it is "auto" for what can and has no
/// end.
bool is_endless(const View& view, const Snapshot& first);

/// Throws InputError where a look whose background is transparent has one that cannot be.
void check_background(const View& view, const Snapshot& first);

/// Throws KeyError where a cover of land, or its snow, is asked for where there is none.
void check_cover(const View& view, const Snapshot& first);

/// Throws KeyError where a sea is asked for and the bed has no edge, one row or no metres.
void check_sea(const View& view, const Snapshot& first);

/// The level of a sea that is asked for, in the heights of the bed.
std::optional<double> known_sea(const View& view, const Snapshot& first);

/// The view with look.ground chosen: where it is "auto", endless for what can be. Throws InputError
/// where it is endless for what cannot be, and as the checks above.
View with_chosen_ground(View view, const Snapshot& first);

}  // namespace fumon
