#pragma once

#include <string>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// Puts the winds of the tables that a scene names (wind.N.table) in their place, so that a
/// resolved scene needs no file. A table's winds of one direction become one. From a rose each
/// blows for its share of the table's duration, at the strength at which its sand of the year, by
/// the saturated flux (sand_flux.h), is what model.flux says; calms are spread over all of them. A
/// threshold_ratio of "auto" becomes that at which relief counts as it does over all winds of the
/// direction, weighed by their sand. Of fluxes each blows for its share of the sand, at the table's
/// strength. Throws InputError, located, where a table cannot be read or moves no sand, where
/// others named it, and where the wind has a speed of its own.
void read_wind_tables(Scene& scene);

/// What the winds of a run move: drift potential, resultant and its direction, as a line; empty for
/// a run without winds.
std::string winds_line(const Snapshot& first);

}  // namespace fumon
