#pragma once

#include <string>
#include <vector>

#include "files/text_source.h"

namespace fumon {

/// Winds of one direction and one speed.
struct WindClass {
    double from = 0.0;               ///< where they blow from, degrees clockwise from north
    double speed = 0.0;              ///< m/s, 10 m above the ground unless another height is told
    double share = 0.0;              ///< of the time
    double friction_velocity = 0.0;  ///< m/s; 0 where the speed is given
};

/// How strongly, and for how much of the time, the wind blows from where. What the shares lack of 1
/// is calm.
using WindRose = std::vector<WindClass>;

/// Sand that moves in one direction.
struct SandFlux {
    double toward = 0.0;  ///< degrees clockwise from north
    double amount = 0.0;  ///< in whatever unit the whole list has
};

/// What a table of winds says: winds, or the sand that they move.
struct WindTable {
    WindRose rose{};                 ///< empty where the table gives fluxes
    std::vector<SandFlux> fluxes{};  ///< empty where the table gives winds
};

/// Reads comma-separated values with a header:
///
/// - `direction`, degrees clockwise from north from which the wind blows, and either
/// - `speed` (m/s) or `speed_knots`, above the ground, or `friction_velocity` (m/s), and how much
///   of the time as `frequency` (a share of the time), `percent` of it or `hours` of the record;
///   without one of these each row is an observation that counts as much as any other; or
/// - `flux`, the sand that this wind moves, in any unit.
///
/// Throws InputError for another header, a cell that is no number or out of range, frequencies that
/// exceed the whole of the time, and a table in which nothing blows.
WindTable read_wind_table(const TextSource& source);

}  // namespace fumon
