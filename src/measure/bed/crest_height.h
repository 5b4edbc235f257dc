#pragma once

#include "base/grid.h"
#include "measure/bed/bed_waves.h"

namespace fumon {

/// The mean of the highest 1 % of the bed's cells (ceil(N/100) of its N cells, at least one), in
/// heights (a profile's height in Sudo 2002, section 5.1). It rises with the mean height of the
/// bed, and in a bed of a few dunes it is that of the highest one. NaN for an empty bed. Every cell
/// must hold a number.
double top_one_percent_mean(const Grid& bed);

/// The mean height of a wave from its trough to its crest: highest minus lowest site of every wave
/// along x, a wave being what lies between two upward crossings with hysteresis (see
/// wavelength_crossings), over all rows. Where the bed is not periodic, heights are above each
/// row's fitted line, and what lies before the first and after the last crossing is left out. NaN
/// where there is no wave. A row that grazes a dune's flank counts like one over its top, so that
/// isolated dunes come out lower than their tops.
double crest_to_trough_height(const Grid& bed, bool periodic);

/// The same of waves that were counted.
double crest_to_trough(const BedWaves& waves);

}  // namespace fumon
