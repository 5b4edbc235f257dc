#pragma once

#include <span>
#include <vector>

namespace fumon {

/// A maximum of a line.
struct LineMaximum {
    int site = 0;
    double value = 0.0;
    double prominence = 0.0;
};

/// The maxima of a line whose prominence is at least `least`, by rising site.
///
/// A maximum is a site above its neighbours, or a run of equal sites above theirs, which counts
/// once at its middle. Its prominence is topographic: its value less the highest saddle on the way
/// to higher ground, the saddle being the lowest value on the way there to the one side or the
/// other; where there is no higher ground, its value less the line's lowest. Of equal maxima the
/// first counts as the higher, so that a shallow dip does not make two great ones of one. A line
/// that is not periodic is taken as mirrored at its ends: an end may be a maximum, and there is no
/// higher ground beyond. A level line has no maximum.
std::vector<LineMaximum> prominent_maxima(std::span<const double> line, bool periodic,
                                          double least);

}  // namespace fumon
