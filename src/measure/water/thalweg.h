#pragma once

#include <span>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// The columns in which a channel is looked for; they may lie past the edges of a periodic slope.
struct ChannelWindow {
    int first = 0;
    int last = 0;
};

/// The windows of channels whose columns are given, ascending: up to half the way to the next one
/// on either side; to the edge where there is none, and half the width either way for one alone on
/// a periodic slope.
std::vector<ChannelWindow> channel_windows(std::span<const int> sites, int nx, bool periodic);

/// Where the deepest water of a channel runs: the x of each row from south to north, in cells.
///
/// Of all ways through the window that go one cell aside at most from row to row it is the one with
/// the largest sum of the depth, which is smoothed by a Gaussian of 2 cells both ways before; of
/// equal ones the straightest. In each row it is then refined by a parabola, by half a cell at
/// most, and smoothed by a Gaussian of 2 cells, so that the steps of the grid do not lengthen it:
/// the height of bends is lessened by that, of a wave of 50 cells by 6 %, of one of 15 by half.
std::vector<double> thalweg(const Grid& smooth_depth, ChannelWindow window, bool periodic);

/// The depth as thalweg() takes it: smoothed by a Gaussian of 2 cells along x and y.
Grid smoothed_depth(const Grid& depth, bool periodic);

/// The mean over channels (their columns, see find_channels) of the thalweg's length over the
/// distance between its ends: 1 for straight ones, askew or not. NaN without a channel and for
/// fewer than 3 rows. Cell sizes in metres.
double mean_sinuosity(const Grid& depth, std::span<const int> sites, double dx, double dy,
                      bool periodic);

}  // namespace fumon
