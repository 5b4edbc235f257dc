#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "measure/network/flow_routing.h"
#include "measure/shared/undefined.h"

namespace fumon {

/// Channels: the cells through which at least a given area drains (O'Callaghan & Mark 1984), and
/// the streams that they make by the orders of Strahler (1957): a stream that begins is of order 1;
/// where two of order k meet, one of order k + 1 begins.
struct ChannelNetwork {
    Field<std::uint8_t> order;    ///< of each cell; 0: no channel
    std::vector<double> streams;  ///< how many there are of order 1, 2 …
    std::vector<double> lengths;  ///< of these together, in the unit of dx
    double total_length = 0.0;
};

/// Throws InputError where the threshold is not above 0.
ChannelNetwork channel_network(const FlowRouting& routing, const Grid& area, double threshold);

/// The weighted mean of the ratios values[i] / values[i + 1] of successive orders, each weighted by
/// the number of streams that it rests on, streams[i] + streams[i + 1] (Strahler 1953, Eos Trans.
/// AGU 34:345; Schumm 1956, GSA Bull. 67:603): the few streams of the highest orders weigh little.
/// Not a number for fewer than two orders.
double weighted_mean_ratio(const std::vector<double>& values, const std::vector<double>& streams);

/// What a network looks like in numbers. Lengths in the unit of dx, areas in that of dx·dy.
struct NetworkShape {
    double drainage_density = undefined;  ///< length of the channels over the area (Horton 1945)
    double highest_order = undefined;     ///< 0 where there is no channel
    double sources = undefined;           ///< streams of order 1
    /// How many times more streams there are of an order than of the next: 10^(−slope) of the line
    /// through log10 of their numbers over the order (Horton 1945).
    double bifurcation_ratio = undefined;
    double length_ratio = undefined;  ///< the same for how much longer streams of the next one are
    double weighted_bifurcation_ratio = undefined;  ///< the weighted mean of the ratios of numbers
    double weighted_length_ratio = undefined;  ///< … of mean lengths, of an order over the last
    /// θ of slope = k·area^−θ (Flint 1974): minus the slope of the line through the logarithms of
    /// mean slope and area of the channels' cells, in bins of five to the decade of area.
    double concavity = undefined;
    /// h of length = k·area^h (Hack 1957), of the longest way down to the mouth of each stream.
    double hack_exponent = undefined;
    /// Four times the mean distance of the ground from the nearest channel: what lies between
    /// channels where they run side by side.
    double spacing = undefined;
    double longest_path_length = undefined;  ///< from the divide to an outlet
};

/// As channel_network; `wraps_x` as for route_flow. Not a number where there is too little network.
NetworkShape network_shape(const FlowRouting& routing, double threshold, const Mask& nodata,
                           bool wraps_x = false);

}  // namespace fumon
