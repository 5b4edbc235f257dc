#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "figure/overlays/overlay.h"
#include "figure/plot/plot.h"

namespace fumon {

/// The ends of an axis over the values so far: 0 where it is not far from them, and outward the
/// next of 1, 1.5, 2, 3, 4, 5, 6, 8 and 10 times a power of ten, so that the axis changes seldom
/// while values come in. Where all values lie within 0.5 % of their size, a round step around them.
std::pair<double, double> growing_range(std::span<const double> values);

/// What a live plot shows at a frame: the rows up to it as a line, its latest point marked. The
/// axis along it is the whole run where it counts steps or time and `run_end` is above 0, else
/// growing_range(), as is the one up it where overlay.low and overlay.high do not fix it.
Plot live_plot(const OverlaySettings& settings, const MeasuredRows& rows, double run_end);

}  // namespace fumon
