#pragma once

#include <cstddef>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// The power of a bed's rows, summed over them.
struct RowPower {
    std::vector<double> windowed;  ///< see power_along_x()
    /// Not periodic: without a window, of rows that zeros follow, for the autocorrelation; else
    /// empty, since that is the same.
    std::vector<double> padded;
};

/// Both powers in one pass over the bed.
RowPower power_of_rows(const Grid& bed, bool periodic);

/// The transforms of the rows of a periodic bed.
struct RowSpectra {
    int nx = 0;  ///< of the bed; 0: of none
    int ny = 0;
    /// Of rows 8j … 8j + 7 one after the other, of each the modes k = 0 … nx/2, of each the eight
    /// rows side by side; rows that the bed lacks are zero.
    std::vector<double> real;
    std::vector<double> imaginary;
    double squares = 0.0;  ///< of all departures
};

/// The spectra of a periodic bed's rows, into the memory of others, and their power.
RowPower find_row_spectra(const Grid& bed, RowSpectra& spectra);

/// The power |F(k)|² of the bed's departures along x (see RowBatch::detrend) in wave numbers
/// k = 0 … nx/2 (cycles per row), summed over the rows. The rows of a bed that is not periodic are
/// brought to zero at their ends by a Hann window first, which widens a peak to three bins. Empty
/// for an empty bed.
std::vector<double> power_along_x(const Grid& bed, bool periodic);

/// The correlation of the bed's departures with themselves shifted by 0, 1, 2 … sites along x, rows
/// summed, 1 without a shift. Periodic: circular, shifts below nx. Else shifts up to nx/2, the
/// covariance of each being the mean over the sites that overlap. Empty for a bed without relief
/// along x.
std::vector<double> autocorrelation_along_x(const Grid& bed, bool periodic);

/// The same from the powers of the rows of nx sites.
std::vector<double> autocorrelation(const RowPower& of_rows, std::size_t nx, bool periodic);

/// The circular correlation of `later` shifted back by 0, 1, 2 … nx − 1 sites along x with
/// `earlier`, rows summed, between −1 and 1: where it is high at shift s, the pattern has moved s
/// sites toward +x. Both beds periodic and of one size (throws Error). Empty where one of them has
/// no relief along x.
std::vector<double> cross_correlation_along_x(const Grid& earlier, const Grid& later);

/// The same from the spectra of their rows.
std::vector<double> cross_correlation(const RowSpectra& earlier, const RowSpectra& later);

}  // namespace fumon
