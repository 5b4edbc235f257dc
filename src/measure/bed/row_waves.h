#pragma once

#include <span>
#include <vector>

namespace fumon {

/// The sites where a row rises into its upper part, with hysteresis (a Schmitt trigger): below the
/// mean − sd/2 arms it, the next site above the mean + sd/2 counts and disarms it (for Sudo 2002's
/// profile). `departures` are a row's heights above its mean (see detrend_row); sd is
/// their standard deviation. Written to `sites`, ascending; none in a row without relief. Periodic:
/// exact, the state in which the row begins is the one in which it ends. Else a rise counts only
/// after an arming site of the row itself.
void find_upward_crossings(std::span<const double> departures, bool periodic,
                           std::vector<int>& sites);

}  // namespace fumon
