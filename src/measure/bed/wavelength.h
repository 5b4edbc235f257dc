#pragma once

#include "base/grid.h"
#include "measure/bed/bed_waves.h"
#include "measure/bed/row_spectrum.h"

namespace fumon {

// Three measures of the wavelength of a bed along x, in sites; each is NaN for a bed without relief
// along x or with fewer than 4 columns. They agree where the pattern is regular. Where it is not,
// the spectrum follows the waves that carry most of the relief, the crossings count every wave
// alike, and the autocorrelation tells the distance to the next crest.

/// nx / k, where k is the centroid of the power spectrum along x (power_along_x) over its highest
/// bin ± 2. Resolution is well below one bin where the pattern has a clear wavelength; it is coarse
/// where only one to three waves fit into the bed, and follows the longest undulation where power
/// rises toward small wave numbers.
double wavelength_spectrum(const Grid& bed, bool periodic);

/// The first peak of the autocorrelation along x (autocorrelation_along_x): its highest value
/// between the first shift at which it has become positive again after having been negative and the
/// shift at which it next turns negative, refined by a parabola. In a periodic bed one wave in the
/// whole bed is found as nx. NaN where the correlation does not return: in beds that are not
/// periodic a peak at a shift beyond nx/2 is not looked for. A parabola through a sharp peak is off
/// by up to a tenth of a site.
double wavelength_autocorrelation(const Grid& bed, bool periodic);

/// Sites for each upward crossing with hysteresis at the mean ± half a standard deviation of the
/// row (find_waves): periodic, the number of sites over the number of crossings; else
/// the distance from the first to the last crossing over the waves between, rows summed. The
/// default for profiles. Waves lower than about half a standard deviation on either
/// side of the mean are passed over. Exceeds nx where many rows cross no dune. NaN without a
/// crossing (not periodic: without two in one row).
double wavelength_crossings(const Grid& bed, bool periodic);

// The same from what others share of a bed of nx columns.
double wavelength_of_spectrum(const RowPower& of_rows, int nx);
double wavelength_of_autocorrelation(const RowPower& of_rows, int nx, bool periodic);
double wavelength_of_crossings(const BedWaves& waves, int nx);

}  // namespace fumon
